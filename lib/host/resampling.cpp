#include "host/resampling.h"

#include "host/averages.h"
#include "host/maps.h"

namespace lobelia::host {

namespace {

Outcome<GpuImage> make_cube(Gpu& gpu, std::uint32_t face) {
    return gpu.create_image(
        {.width = face, .height = face, .layers = 6, .usage = ENVIRONMENT_USAGE, .cube = true});
}

} // namespace

Outcome<Resampling> Resampling::create(Gpu& gpu, const GpuImage& panorama, std::uint32_t face) {
    const GpuImageDescription& shape = panorama.description();
    auto cube = make_cube(gpu, face);
    if (!cube) return cube.error();
    const auto pass = PanoramaToCube::create(gpu.device());
    if (!pass) return core_failure(pass.error());
    auto job = pass->bind({panorama.handle(), shape.format, shape.width, shape.height},
                          {cube->handle(), shape.format, face, 1});
    if (!job) return core_failure(job.error());
    return Resampling{std::move(*cube), std::move(*job)};
}

Outcome<std::optional<Resizing>> Resizing::create(Gpu& gpu, const GpuImage& source) {
    const std::uint32_t face = prefilter_face(source.description().width);
    if (face == source.description().width) return std::optional<Resizing>{};
    auto cube = make_cube(gpu, face);
    if (!cube) return cube.error();
    const auto pass = CubeToCube::create(gpu.device());
    if (!pass) return core_failure(pass.error());
    auto job = pass->bind(lend_cube(source), lend_cube(*cube));
    if (!job) return core_failure(job.error());
    return std::optional<Resizing>({std::move(*cube), std::move(*job)});
}

} // namespace lobelia::host
