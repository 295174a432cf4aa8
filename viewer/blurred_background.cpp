#include "blurred_background.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr std::uint32_t FACE = 64; // texels

// All of the light that a mirror of that lobe would show.
host::RenderSettings settings_for(const ViewState& state) {
    return {.view = {.material = {.specular = {1.0f, 1.0f, 1.0f}, .exponent = state.blur},
                     .background = false,
                     .width = 1,
                     .height = 1},
            .method = SphereMethod::split_sum,
            .quality = state.settings.quality};
}

} // namespace

void BlurredBackground::forget() {
    map_.reset();
    blurred_by_ = -1.0f;
    ready_ = true;
    ++version_;
}

Outcome<Done> BlurredBackground::update(host::Gpu& gpu, Lights& lights, const ViewState& state,
                                        FrameWork& work,
                                        std::chrono::steady_clock::time_point end) {
    if (state.background != Background::blurred) {
        if (map_ || !ready_) forget();
        return Done{};
    }
    if (blurred_by_ == state.blur) return Done{};
    ready_ = false;
    const auto plan = lights.plan(settings_for(state), state.material().exponent);
    if (!plan) return plan.error();
    // No picture's method: pictures do not take these maps for theirs.
    const auto light = lights.advance(*plan, SphereMethod::plain_split_sum, state.blur, work, end);
    if (!light) return light.error();
    if ((*light)->maps.passes_left() || !Lights::serves(**light, *plan)) return Done{};
    ready_ = true;
    blurred_by_ = state.blur;
    ++version_;
    if (!plan->prefilter()) return Done{}; // the same everywhere: blurred as it is
    const auto values = (*light)->maps.read_map(0, FACE);
    if (!values) return values.error();
    auto image =
        gpu.create_image({.width = FACE,
                          .height = FACE,
                          .layers = 6,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          .cube = true});
    if (!image) return image.error();
    if (const auto done = gpu.upload(*values, *image); !done) return done.error();
    map_ = std::move(*image);
    return Done{};
}

} // namespace lobelia::cli
