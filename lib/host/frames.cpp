#include <lobelia/host/frames.h>

#include <chrono>
#include <vector>

#include <lobelia/clipped_tables.h>

#include "host/checks.h"
#include "host/colour_target.h"
#include "host/maps.h"
#include "host/warm_cost.h"

namespace lobelia::host {

namespace {

/// Everything that a frame's commands refer to.
struct Stage {
    GpuEnvironment environment;
    MapsJob maps;
    GpuImage tables;
    ColourTarget target;
    SphereJob sphere;
};

Outcome<Stage> set_up(Gpu& gpu, const RenderSettings& settings, const Image& first) {
    auto environment = upload_environment(gpu, first);
    if (!environment) return environment.error();
    const SphereView& view = settings.view;
    const float exponent = view.material.exponent;
    auto maps = bind_maps(gpu, *environment,
                          {.lambert = true,
                           .ladder = ladder_for(Taps::two, exponent, exponent),
                           .quality = settings.quality});
    if (!maps) return maps.error();
    if (environment->resized)
        return Failure{"the light's cube maps have faces of " + std::to_string(first.width) +
                       " texels, give a power of two from 16 to 1024"};
    PassReport upload; // is no part of a frame
    auto tables = make_clipped_tables(gpu, upload);
    if (!tables) return tables.error();
    auto target = ColourTarget::create(gpu, view.width, view.height);
    if (!target) return target.error();
    const auto sphere =
        Sphere::create(gpu.device(), {.render_pass = target->render_pass()},
                       {.method = SphereMethod::two_tap, .background = view.background});
    if (!sphere) return core_failure(sphere.error());
    auto job = sphere->bind({.background = environment->cube.view(),
                             .diffuse = maps->maps.images.back().view(),
                             .prefilter_state = maps->maps.state.handle(),
                             .ladder = maps->maps.ladder->view(),
                             .clipped_tables = tables->view()});
    if (!job) return core_failure(job.error());
    return Stage{std::move(*environment), std::move(*maps), std::move(*tables), std::move(*target),
                 std::move(*job)};
}

/// Times of the same work, frame by frame.
class FrameTimes {
public:
    Outcome<Done> run(Gpu& gpu, const std::function<void(VkCommandBuffer)>& record) {
        const auto start = std::chrono::steady_clock::now();
        PassReport ran;
        if (const auto done = run_pass(gpu, ran, record); !done) return done.error();
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - start;
        cpu_.push_back(ran.cpu_ms.value_or(0.0));
        wall_.push_back(passed.count());
        return Done{};
    }
    Frames::Time time() const { return {median(cpu_), median(wall_)}; }

private:
    std::vector<double> cpu_, wall_;
};

} // namespace

Outcome<Frames> draw_frames(Gpu& gpu, const RenderSettings& settings, std::size_t count,
                            const std::function<FrameLight(std::size_t)>& light,
                            const std::function<Outcome<Done>(std::size_t, Image)>& show) {
    if (count == 0) return Failure{"there are no frames, give at least one"};
    if (const auto refused = check_view(settings.view, gpu.limits())) return *refused;
    if (const auto refused = check_material(settings.view.material, true)) return *refused;
    const auto stage = set_up(gpu, settings, light(0).cube);
    if (!stage) return stage.error();
    SphereView view = settings.view;
    const auto draw = [&](VkCommandBuffer commands) {
        stage->target.record(commands,
                             [&](VkCommandBuffer inside) { stage->sphere.record(inside, view); });
    };
    const auto prefilter_and_draw = [&](VkCommandBuffer commands) {
        stage->maps.job.record(commands, 0, stage->maps.plan.pass_count());
        draw(commands);
    };
    // A driver's own compilation is no part of a frame.
    if (const auto warm = gpu.submit(prefilter_and_draw); !warm) return warm.error();

    FrameTimes still, changing;
    for (std::size_t i = 0; i < count; ++i) {
        const FrameLight now = light(i);
        view.environment_rotation = now.rotation;
        if (const auto there = gpu.upload(now.cube, stage->environment.cube); !there)
            return there.error();
        if (const auto done = changing.run(gpu, prefilter_and_draw); !done) return done.error();
        if (const auto done = still.run(gpu, draw); !done) return done.error();
        auto picture = gpu.download(stage->target.image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        if (!picture) return picture.error();
        if (const auto shown = show(i, std::move(*picture)); !shown) return shown.error();
    }
    return Frames{still.time(), changing.time()};
}

} // namespace lobelia::host
