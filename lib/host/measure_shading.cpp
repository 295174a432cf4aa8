#include "host/averages.h"
#include "host/checks.h"
#include "host/drawing.h"
#include "host/sizes.h"
#include "host/warm_cost.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LEAST_SIZE = 64;

/// Methods of many samples take seconds for a large picture: they are timed in one that is a half
/// as wide, a quarter, ... This is the first, from small to large, of which the next would take too
/// long. By each other's times: those of the smallest say little of large ones.
Outcome<Drawing> affordable_drawing(Gpu& gpu, const SphereInputs& inputs, SphereView view,
                                    std::uint32_t timed_size) {
    int halvings = 0;
    while (timed_size >> halvings > LEAST_SIZE) ++halvings;
    for (;; --halvings) {
        view.width = view.height = timed_size >> halvings;
        auto drawing = Drawing::create(gpu, inputs, view);
        if (!drawing) return drawing.error();
        PassReport first, warm;
        if (const auto done = drawing->run(gpu, first); !done) return done.error();
        if (const auto done = drawing->run(gpu, warm); !done) return done.error();
        if (halvings == 0 || 4.0 * warm.cpu_ms.value_or(0.0) > AFFORDABLE_MILLISECONDS)
            return drawing;
    }
}

Outcome<std::vector<float>> covered_colours(Gpu& gpu, const Drawing& drawing) {
    PassReport run;
    if (const auto done = drawing.run(gpu, run); !done) return done.error();
    const auto picture = drawing.picture(gpu);
    if (!picture) return picture.error();
    std::vector<float> colours;
    for (std::size_t i = 0; i < picture->texels.size(); i += 4)
        if (picture->texels[i + 3] == 1.0f)
            colours.insert(colours.end(), &picture->texels[i], &picture->texels[i] + 3);
    if (colours.empty()) return Failure{"the sphere covers no pixel wholly, give a larger size"};
    return colours;
}

/// Of the passes that made the inputs: for the reference they are the work.
Cost cost_of_inputs(const SphereInputs& inputs, const SphereView& view, std::uint32_t timed_size) {
    PassReport all;
    std::uint64_t bytes = 0;
    for (const PassReport& pass : inputs.report.passes) {
        add_times(all, pass);
        bytes += pass.bytes_read + pass.bytes_written;
    }
    Cost cost = once(all, double(timed_size) * timed_size / (double(view.width) * view.height));
    cost.bytes = bytes;
    cost.dispatches = inputs.report.passes.size();
    return cost;
}

/// A picture with what it is drawn from.
struct Scene {
    SphereInputs inputs;
    std::optional<Drawing> drawing{};
};

Outcome<Untimed> shade(Gpu& gpu, const GpuEnvironment& environment, const RenderSettings& settings,
                       std::uint32_t timed_size) {
    SphereView view = settings.view;
    view.background = false;
    if (const auto refused = check_view(view, gpu.limits())) return *refused;
    if (const auto refused = check_material(view.material, true)) return *refused;
    auto inputs = make_sphere_inputs(gpu, environment, settings, {});
    if (!inputs) return inputs.error();
    const auto scene = std::make_shared<Scene>(Scene{std::move(*inputs)});
    const auto small = Drawing::create(gpu, scene->inputs, view);
    if (!small) return small.error();
    auto colours = covered_colours(gpu, *small);
    if (!colours) return colours.error();
    Untimed method{{.colours = std::move(*colours)}};
    if (settings.method == SphereMethod::reference) {
        method.found.cost = cost_of_inputs(scene->inputs, view, timed_size);
        return method;
    }

    auto drawing = affordable_drawing(gpu, scene->inputs, view, timed_size);
    if (!drawing) return drawing.error();
    const double scale = double(timed_size) / drawing->view.width;
    scene->drawing = std::move(*drawing);
    method.work = {[&gpu, scene](PassReport& report) { return scene->drawing->run(gpu, report); },
                   scale * scale};
    method.found.cost.bytes = scene->inputs.bytes + TEXEL_BYTES * timed_size * timed_size;
    method.found.cost.dispatches = 1;
    return method;
}

} // namespace

Outcome<std::vector<Measured>> measure_shading(Gpu& gpu, std::span<const ShadingCase> cases,
                                               std::uint32_t timed_size) {
    std::vector<Untimed> methods;
    for (const ShadingCase& one : cases) {
        auto method = shade(gpu, *one.environment, one.settings, timed_size);
        if (!method) return method.error();
        methods.push_back(std::move(*method));
    }
    return add_warm_costs(gpu, std::move(methods));
}

} // namespace lobelia::host
