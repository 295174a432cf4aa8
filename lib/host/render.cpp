#include <lobelia/host/work.h>

#include "host/drawing.h"
#include "host/guard.h"
#include "host/scene_plan.h"

namespace lobelia::host {

namespace {

Image black_picture(const SphereView& view) {
    return {.width = view.width,
            .height = view.height,
            .texels = std::vector<float>(std::size_t(4) * view.width * view.height)};
}

Outcome<Rendering> render_sphere(Gpu& gpu, const GpuEnvironment& environment,
                                 const RenderSettings& settings, const Progress& progress) {
    if (const auto valid = check_render(gpu, settings); !valid) return valid.error();
    const SphereView& view = settings.view;
    const auto inputs = make_sphere_inputs(gpu, environment, settings, progress);
    if (!inputs) return inputs.error();
    if (!inputs->plan.draws()) return Rendering{black_picture(view), inputs->report};

    const auto drawing = Drawing::create(gpu, *inputs, view);
    if (!drawing) return drawing.error();
    PassReport run = report_of(inputs->plan.passes().back());
    if (const auto drawn = drawing->run(gpu, run); !drawn) return drawn.error();
    auto picture = drawing->picture(gpu);
    if (!picture) return picture.error();
    Rendering rendering{std::move(*picture), inputs->report};
    rendering.report.passes.push_back(run);
    return rendering;
}

} // namespace

Outcome<Rendering> render(Gpu& gpu, const GpuEnvironment& environment,
                          const RenderSettings& settings, const Progress& progress) {
    return guarded([&] { return render_sphere(gpu, environment, settings, progress); });
}

} // namespace lobelia::host
