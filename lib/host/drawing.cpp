#include "host/drawing.h"

#include "host/averages.h"

namespace lobelia::host {

Outcome<Drawing> Drawing::create(Gpu& gpu, const SphereInputs& inputs, const SphereView& view) {
    auto target = ColourTarget::create(gpu, view.width, view.height);
    if (!target) return target.error();
    const auto sphere =
        Sphere::create(gpu.device(), {.render_pass = target->render_pass()}, inputs.shading);
    if (!sphere) return core_failure(sphere.error());
    auto job = sphere->bind(inputs.sources);
    if (!job) return core_failure(job.error());
    return Drawing{std::move(*target), std::move(*job), view};
}

Outcome<Done> Drawing::run(Gpu& gpu, PassReport& report) const {
    return run_pass(gpu, report, [&](VkCommandBuffer commands) {
        target.record(commands, [&](VkCommandBuffer inside) { job.record(inside, view); });
    });
}

Outcome<Image> Drawing::picture(Gpu& gpu) const {
    return gpu.download(target.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

} // namespace lobelia::host
