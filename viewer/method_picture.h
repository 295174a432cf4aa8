#pragma once

#include "lights.h"

namespace lobelia::cli {

/// What a picture is to show.
struct PictureRequest {
    host::RenderSettings settings; // its view as shown_view()
    VkImageView background = VK_NULL_HANDLE;
    std::uint64_t version = 0; // of the environment and the background
};

/// The picture by one method. Until maps are whole it shows the ones before.
class MethodPicture {
public:
    /// Works on maps until `end`, and draws where the picture would change.
    host::Outcome<Done> update(host::Gpu& gpu, Lights& lights, SpherePipelines& pipelines,
                               const PictureRequest& request, FrameWork& work,
                               std::chrono::steady_clock::time_point end);
    /// Whether the picture is what was asked for, and how much of the maps for it is there.
    bool is_ready() const { return ready_; }
    double maps_done() const { return maps_done_; }

    const Picture* picture() const { return drawing_.picture(); }
    const Lights::Light* light() const { return light_; }
    /// The lights are not there any more; what was drawn stays.
    void forget();
    /// Likewise of the method: another one's picture is not shown in its place.
    void leave() { light_ = nullptr; }

private:
    host::Outcome<Done> plan(const Lights& lights, const PictureRequest& request);

    using PlanKey = std::tuple<SphereMethod, Quality, std::uint32_t, float, bool, bool, bool, bool,
                               std::uint32_t, std::uint32_t>;
    std::optional<PlanKey> planned_;
    std::optional<ScenePlan> plan_; // of what was asked for
    Lights::Light* light_ = nullptr;
    Drawing drawing_;
    bool ready_ = false;
    double maps_done_ = 1.0;
};

} // namespace lobelia::cli
