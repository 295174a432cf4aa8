#include "blurred_background.h"

namespace lobelia::cli {

using host::Outcome;

Outcome<Done> BlurredBackground::update(host::Gpu& gpu, const host::GpuEnvironment& environment,
                                        const ViewState& state, FrameWork& work) {
    if (state.background != Background::blurred) {
        if (map_) forget();
        return Done{};
    }
    if (map_ && blurred_by_ == state.blur) return Done{};
    const auto maps = host::prefilter(
        gpu, environment, {.quality = Quality::fast, .exponents = {state.blur}, .width = 64});
    if (!maps) return maps.error();
    work.insert(work.end(), maps->report.passes.begin(), maps->report.passes.end());
    const host::Image& map = maps->maps.front();
    auto image =
        gpu.create_image({.width = map.width,
                          .height = map.height,
                          .layers = 6,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          .cube = true});
    if (!image) return image.error();
    if (const auto done = gpu.upload(map, *image); !done) return done.error();
    map_ = std::move(*image);
    blurred_by_ = state.blur;
    ++version_;
    return Done{};
}

} // namespace lobelia::cli
