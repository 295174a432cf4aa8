#include "host/resampling.h"

#include "host/averages.h"

namespace lobelia::host {

Outcome<Resampling> Resampling::create(Gpu& gpu, const GpuImage& panorama, std::uint32_t face) {
    const GpuImageDescription& shape = panorama.description();
    auto cube = gpu.create_image(
        {.width = face, .height = face, .layers = 6, .usage = ENVIRONMENT_USAGE, .cube = true});
    if (!cube) return cube.error();
    const auto pass = PanoramaToCube::create(gpu.device());
    if (!pass) return core_failure(pass.error());
    auto job = pass->bind({panorama.handle(), shape.format, shape.width, shape.height},
                          {cube->handle(), shape.format, face, 1});
    if (!job) return core_failure(job.error());
    return Resampling{std::move(*cube), std::move(*job)};
}

} // namespace lobelia::host
