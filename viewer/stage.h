#pragma once

#include <chrono>
#include <list>
#include <optional>

#include <lobelia/host/progressive_reference.h>

#include "display.h"
#include "drawing.h"
#include "light.h"
#include "view_state.h"

namespace lobelia::cli {

/// The pictures that the window shows, and all that they are made of. Each update works for a part
/// of a frame's time; until new maps are whole the pictures show the old ones.
class Stage {
public:
    static host::Outcome<Stage> create(host::Gpu& gpu);

    /// Shows this environment from now on.
    host::Outcome<Done> set_environment(host::GpuEnvironment environment);
    const host::GpuEnvironment* environment() const { return environment_.get(); }

    /// Goes on towards what `state` says, in pictures of that size; adds what was run to `work`.
    host::Outcome<Done> update(const ViewState& state, VkExtent2D extent, FrameWork& work);
    /// Whether another update would change the pictures, though the state stays.
    bool is_busy() const { return busy_; }
    /// Of all maps that the pictures wait for, 1 where they wait for none.
    double maps_done() const { return maps_done_; }
    /// The same of the reference; nothing where none is asked for.
    std::optional<double> reference_done() const;
    std::uint64_t bytes() const; // of the maps

    bool has_pictures() const { return left_.picture() != nullptr; }
    DisplaySources display_sources(const ViewState& state) const;
    DisplayParams display_params(const ViewState& state, VkExtent2D extent) const;

    /// Linear radiance of the left or right picture, and of the reference where it is there.
    host::Outcome<host::Image> download(const ViewState& state, bool right);
    struct Probe {
        std::array<float, 3> shown{}, exact{};
    };
    /// One pixel on the sphere, shown and exact.
    host::Outcome<Probe> probe(const ViewState& state, std::uint32_t x, std::uint32_t y);

private:
    using Clock = std::chrono::steady_clock;
    Stage(host::Gpu& gpu, LightPasses passes, OwnedRenderPass pass)
        : gpu_(&gpu), passes_(std::move(passes)), pass_(std::move(pass)),
          pipelines_(gpu, pass_.get()) {}
    host::Outcome<Light*> light_for(const LightRequest& request, FrameWork& work,
                                    Clock::time_point end);
    host::Outcome<Done> draw_method(Drawing& drawing, Light*& shown, SphereMethod method,
                                    const ViewState& state, const SphereView& view, FrameWork& work,
                                    Clock::time_point end);
    host::Outcome<Done> update_background(const ViewState& state, FrameWork& work);
    host::Outcome<Done> update_reference(const ViewState& state, const SphereView& view,
                                         FrameWork& work);
    host::Outcome<Done> fit_unknown(VkExtent2D extent);
    const Picture& picture(const ViewState& state, bool right) const;

    host::Gpu* gpu_;
    LightPasses passes_;
    OwnedRenderPass pass_;
    SpherePipelines pipelines_;
    std::unique_ptr<host::GpuEnvironment> environment_;
    std::optional<host::GpuImage> resized_; // its cube map, where prefilters do not read that
    std::uint64_t version_ = 0;             // of the environment
    std::list<Light> lights_;               // the latest first
    Light *left_light_ = nullptr, *right_light_ = nullptr; // shown
    std::optional<host::GpuImage> blurred_;
    float blurred_by_ = -1.0f;
    std::optional<host::ProgressiveReference> reference_;
    std::optional<SphereView> reference_view_; // that it is of, or will be once that stays
    Clock::time_point reference_asked_;
    std::uint64_t reference_version_ = 0;
    std::optional<host::GpuBuffer> unknown_; // what is known where there is no reference
    Drawing left_, right_, exact_;
    bool busy_ = false;
    double maps_done_ = 1.0;
};

} // namespace lobelia::cli
