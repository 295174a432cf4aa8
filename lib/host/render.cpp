#include <lobelia/host/work.h>

#include "host/averages.h"
#include "host/checks.h"
#include "host/colour_target.h"
#include "host/sphere_inputs.h"

namespace lobelia::host {

namespace {

Outcome<Done> check(const Gpu& gpu, const RenderSettings& settings) {
    if (const auto refused = check_view(settings.view, gpu.limits())) return *refused;
    if (const auto refused = check_material(settings.view.material, true)) return *refused;
    if (settings.samples < 1 || settings.samples > SphereShading::MOST_SAMPLES)
        return Failure{"there are " + std::to_string(settings.samples) + " samples, give 1 to " +
                       std::to_string(SphereShading::MOST_SAMPLES)};
    return Done{};
}

} // namespace

Outcome<Rendering> render(Gpu& gpu, const GpuEnvironment& environment,
                          const RenderSettings& settings, const Progress& progress) {
    if (const auto valid = check(gpu, settings); !valid) return valid.error();
    const SphereView& view = settings.view;
    const auto inputs = make_sphere_inputs(gpu, environment, settings, progress);
    if (!inputs) return inputs.error();

    const auto target = ColourTarget::create(gpu, view.width, view.height);
    if (!target) return target.error();
    const auto sphere =
        Sphere::create(gpu.device(), {.render_pass = target->render_pass()}, inputs->shading);
    if (!sphere) return core_failure(sphere.error());
    const auto job = sphere->bind(inputs->sources);
    if (!job) return core_failure(job.error());

    PassReport run{.name = "sphere",
                   .invocations = std::uint64_t(view.width) * view.height,
                   .bytes_read = inputs->bytes,
                   .bytes_written = image_bytes(target->image())};
    const auto drawn = run_pass(gpu, run, [&](VkCommandBuffer commands) {
        target->record(commands, [&](VkCommandBuffer inside) { job->record(inside, view); });
    });
    if (!drawn) return drawn.error();
    auto picture = gpu.download(target->image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    if (!picture) return picture.error();
    Rendering rendering{std::move(*picture), inputs->report};
    rendering.report.passes.push_back(run);
    rendering.report.images.push_back(image_report("picture", target->image(), "kept"));
    return rendering;
}

} // namespace lobelia::host
