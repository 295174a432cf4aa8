#pragma once

#include <optional>

#include "blurred_background.h"
#include "display.h"
#include "method_picture.h"
#include "pick.h"
#include "reference_picture.h"
#include "view_state.h"

namespace lobelia::cli {

/// The pictures that the window shows, and all that they are made of. Each update works for a part
/// of a frame's time; until new maps are whole the pictures show the old ones.
class Stage {
public:
    static host::Outcome<Stage> create(host::Gpu& gpu);

    /// Shows this environment from now on.
    void set_environment(host::GpuEnvironment environment);
    const host::GpuEnvironment* environment() const {
        return lights_ ? &lights_->environment() : nullptr;
    }

    /// Goes on towards what `state` says, in pictures of that size; adds what was run to `work`.
    host::Outcome<Done> update(const ViewState& state, VkExtent2D extent, FrameWork& work);
    /// Whether another update would change the pictures, though the state stays.
    bool is_busy() const { return busy_; }
    /// Of all maps that the pictures wait for, 1 where they wait for none.
    double maps_done() const { return maps_done_; }
    /// The same of the reference; nothing where none is asked for.
    std::optional<double> reference_done() const;
    std::uint64_t bytes() const { return lights_ ? lights_->bytes() : 0; } // of the maps

    bool has_pictures() const { return left_.picture() != nullptr; }
    DisplaySources display_sources(const ViewState& state) const;
    DisplayVariant display_variant(const ViewState& state) const;
    DisplayParams display_params(const ViewState& state, VkExtent2D extent) const;

    /// Linear radiance of the left or right picture, and of the reference where it is there.
    host::Outcome<host::Image> download(const ViewState& state, bool right);
    /// What a pixel shows and what it should; nothing where the sphere is not.
    host::Outcome<std::optional<Pick>> pick(const ViewState& state, std::uint32_t x,
                                            std::uint32_t y);

private:
    Stage(host::Gpu& gpu, SpherePipelines pipelines)
        : gpu_(&gpu), passes_(gpu), pipelines_(std::move(pipelines)) {}
    PictureRequest request_for(const ViewState& state, VkExtent2D extent,
                               SphereMethod method) const;
    host::Outcome<Done> update_pictures(const ViewState& state, VkExtent2D extent, FrameWork& work);
    host::Outcome<Done> fit_unknown(VkExtent2D extent);
    const Picture& picture(const ViewState& state, bool right) const;

    host::Gpu* gpu_;
    host::MapPasses passes_;
    SpherePipelines pipelines_;
    std::optional<Lights> lights_;
    std::uint64_t environments_ = 0; // so far
    BlurredBackground background_;
    MethodPicture left_, right_;
    ReferencePicture reference_;
    std::optional<host::GpuBuffer> unknown_; // what is known where there is no reference
    bool busy_ = false;
    double maps_done_ = 1.0;
};

} // namespace lobelia::cli
