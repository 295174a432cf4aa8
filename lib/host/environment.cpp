#include <algorithm>
#include <bit>

#include <lobelia/host/work.h>
#include <lobelia/sky.h>

#include "host/averages.h"
#include "host/environment_plan.h"
#include "host/guard.h"
#include "host/resampling.h"

namespace lobelia::host {

// A texel of the panorama's equator is as wide as one in the middle of a face of width / 4.
std::uint32_t default_face(std::uint32_t panorama_width, Quality quality) {
    const std::uint32_t face = std::bit_ceil(std::max((panorama_width + 3) / 4, 1u));
    return quality == Quality::high ? 2 * face : face;
}

namespace {

Outcome<GpuEnvironment> paint_environment(Gpu& gpu, std::uint32_t face, Quality quality) {
    auto panorama = gpu.create_image(
        {.width = BUILTIN_WIDTH, .height = BUILTIN_WIDTH / 2, .usage = ENVIRONMENT_USAGE});
    if (!panorama) return panorama.error();
    const auto sky = Sky::create(gpu.device());
    if (!sky) return core_failure(sky.error());
    const auto job =
        sky->bind({panorama->handle(), panorama->view(), BUILTIN_WIDTH, BUILTIN_WIDTH / 2});
    if (!job) return core_failure(job.error());

    EnvironmentPlan plan = plan_environment(builtin_shape(), face, quality);
    std::vector<PassReport>& passes = plan.report.passes; // sky, cube map, and that resized
    auto resampling = Resampling::create(gpu, *panorama, plan.face);
    if (!resampling) return resampling.error();
    const auto painted =
        run_pass(gpu, passes[0], [&](VkCommandBuffer commands) { job->record(commands); });
    if (!painted) return painted.error();
    const auto resampled = run_pass(
        gpu, passes[1], [&](VkCommandBuffer commands) { resampling->job.record(commands); });
    if (!resampled) return resampled.error();
    auto resizing = Resizing::create(gpu, resampling->cube);
    if (!resizing) return resizing.error();
    GpuEnvironment environment{
        .panorama = std::move(*panorama), .cube = std::move(resampling->cube), .report = {}};
    if (*resizing) {
        const auto resized = run_pass(
            gpu, passes[2], [&](VkCommandBuffer commands) { (*resizing)->job.record(commands); });
        if (!resized) return resized.error();
        environment.resized = std::move((*resizing)->cube);
    }
    environment.report = std::move(plan.report);
    return environment;
}

} // namespace

Outcome<GpuEnvironment> make_builtin_environment(Gpu& gpu, std::uint32_t face, Quality quality) {
    return guarded([&] { return paint_environment(gpu, face, quality); });
}

} // namespace lobelia::host
