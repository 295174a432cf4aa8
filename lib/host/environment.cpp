#include <algorithm>
#include <bit>

#include <lobelia/host/work.h>
#include <lobelia/panorama.h>
#include <lobelia/sky.h>

#include "host/averages.h"
#include "host/environment_plan.h"
#include "host/guard.h"

namespace lobelia::host {

namespace {

constexpr VkImageUsageFlags USAGE = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                    VK_IMAGE_USAGE_TRANSFER_DST_BIT;

GpuImageDescription cube_shape(std::uint32_t face) {
    return {.width = face, .height = face, .layers = 6, .usage = USAGE, .cube = true};
}

/// Makes the cube map; the last pass of the plan.
Outcome<GpuEnvironment> resample(Gpu& gpu, GpuImage panorama, EnvironmentPlan plan) {
    const GpuImageDescription& shape = panorama.description();
    auto cube = gpu.create_image(cube_shape(plan.face));
    if (!cube) return cube.error();
    const auto pass = PanoramaToCube::create(gpu.device());
    if (!pass) return core_failure(pass.error());
    const std::uint32_t size = cube->description().width;
    const auto job = pass->bind({panorama.handle(), shape.format, shape.width, shape.height},
                                {cube->handle(), shape.format, size, 1});
    if (!job) return core_failure(job.error());

    const auto done = run_pass(gpu, plan.report.passes.back(),
                               [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    return GpuEnvironment{std::move(panorama), std::move(*cube), std::move(plan.report)};
}

Outcome<GpuEnvironment> upload_cube(Gpu& gpu, const Image& image) {
    auto cube = gpu.create_image(cube_shape(image.width));
    if (!cube) return cube.error();
    if (const auto done = gpu.upload(image, *cube); !done) return done.error();
    const EnvironmentShape shape = shape_of(image);
    return GpuEnvironment{std::nullopt, std::move(*cube),
                          plan_environment(shape, 0, Quality::normal).report, shape.constant};
}

Outcome<GpuEnvironment> upload_panorama(Gpu& gpu, const Image& image, std::uint32_t face,
                                        Quality quality) {
    auto panorama =
        gpu.create_image({.width = image.width, .height = image.height, .usage = USAGE});
    if (!panorama) return panorama.error();
    if (const auto done = gpu.upload(image, *panorama); !done) return done.error();
    const EnvironmentShape shape = shape_of(image);
    auto environment = resample(gpu, std::move(*panorama), plan_environment(shape, face, quality));
    if (environment) environment->constant = shape.constant;
    return environment;
}

bool is_complete(const Image& image) {
    const bool shaped = image.layout == Layout::cube
                            ? image.layers == 6 && image.width == image.height
                            : image.layers == 1;
    return shaped && image.width > 0 && image.height > 0 &&
           image.texels.size() == std::size_t(4) * image.layers * image.height * image.width;
}

} // namespace

// A texel of the panorama's equator is as wide as one in the middle of a face of width / 4.
std::uint32_t default_face(std::uint32_t panorama_width, Quality quality) {
    const std::uint32_t face = std::bit_ceil(std::max((panorama_width + 3) / 4, 1u));
    return quality == Quality::high ? 2 * face : face;
}

Outcome<GpuEnvironment> upload_environment(Gpu& gpu, const Image& image, std::uint32_t face,
                                           Quality quality) {
    if (!is_complete(image))
        return Failure{"an environment is one panorama or six square faces of R G B A texels"};
    return guarded([&] {
        return image.layout == Layout::cube ? upload_cube(gpu, image)
                                            : upload_panorama(gpu, image, face, quality);
    });
}

namespace {

Outcome<GpuEnvironment> paint_environment(Gpu& gpu, std::uint32_t face, Quality quality) {
    auto panorama =
        gpu.create_image({.width = BUILTIN_WIDTH, .height = BUILTIN_WIDTH / 2, .usage = USAGE});
    if (!panorama) return panorama.error();
    const auto sky = Sky::create(gpu.device());
    if (!sky) return core_failure(sky.error());
    const auto job =
        sky->bind({panorama->handle(), panorama->view(), BUILTIN_WIDTH, BUILTIN_WIDTH / 2});
    if (!job) return core_failure(job.error());

    EnvironmentPlan plan = plan_environment(builtin_shape(), face, quality);
    const auto done = run_pass(gpu, plan.report.passes.front(),
                               [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    return resample(gpu, std::move(*panorama), std::move(plan));
}

} // namespace

Outcome<GpuEnvironment> make_builtin_environment(Gpu& gpu, std::uint32_t face, Quality quality) {
    return guarded([&] { return paint_environment(gpu, face, quality); });
}

} // namespace lobelia::host
