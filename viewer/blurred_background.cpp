#include "blurred_background.h"

namespace lobelia::cli {

using host::Outcome;

void BlurredBackground::forget() {
    light_ = nullptr;
    blurred_by_ = -1.0f;
    ready_ = true;
    ++version_;
}

Outcome<Done> BlurredBackground::update(Lights& lights, const ViewState& state, FrameWork& work,
                                        std::chrono::steady_clock::time_point end) {
    if (state.background != Background::blurred) {
        if (light_ || !ready_) forget();
        return Done{};
    }
    if (blurred_by_ == state.blur) return Done{};
    ready_ = false;
    // A picture of nothing else.
    const host::RenderSettings settings{.view = {.width = 1, .height = 1},
                                        .quality = state.settings.quality,
                                        .background_exponent = state.blur};
    const auto plan = lights.plan(settings, state.material().exponent);
    if (!plan) return plan.error();
    // No picture's method: pictures do not take these maps for theirs.
    const auto light = lights.advance(*plan, SphereMethod::plain_split_sum, state.blur, work, end);
    if (!light) return light.error();
    if ((*light)->maps.passes_left() || !Lights::serves(**light, *plan)) return Done{};
    light_ = *light;
    blurred_by_ = state.blur;
    ready_ = true;
    ++version_;
    return Done{};
}

} // namespace lobelia::cli
