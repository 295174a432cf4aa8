#include "host/sphere_inputs.h"

namespace lobelia::host {

namespace {

constexpr RenderMethod METHODS[] = {
    {SphereMethod::kurt2019, "kurt2019", "six colours of the environment, as the material's paper"},
    {SphereMethod::sh2, "sh2", "diffuse by spherical harmonics of degree 2, the rest as split-sum"},
    {SphereMethod::sh4, "sh4", "the same of degree 4"},
    {SphereMethod::split_sum, "split-sum", "prefiltered maps"},
    {SphereMethod::one_tap, "one-tap", "one lobe for what the horizon leaves of the lobe"},
    {SphereMethod::two_tap, "two-tap", "two lobes"},
    {SphereMethod::hybrid, "hybrid", "five lobes near the horizon"},
    {SphereMethod::importance, "importance", "filtered importance sampling, N samples a lobe"},
    {SphereMethod::reference, "reference",
     "integrates over every texel for every pixel: the ground truth"},
};

Outcome<Done> run(SphereInputs& inputs, const Progress& progress) {
    SceneMaps& maps = inputs.maps;
    while (maps.passes_left()) {
        const auto ran = maps.run_pass();
        if (!ran) return ran.error();
        inputs.report.passes.push_back(*ran);
        const double left = double(maps.passes_left()) / double(maps.pass_count());
        if (progress && !progress(1.0 - left)) return Failure{"cancelled"};
    }
    inputs.report.suns = maps.suns();
    inputs.shading = maps.shading(inputs.plan);
    inputs.sources = maps.sources();
    return Done{};
}

Outcome<Done> add_references(SphereInputs& inputs, Gpu& gpu, const GpuEnvironment& environment,
                             const SphereView& view, const Progress& progress) {
    auto made = make_references(gpu, environment, view, progress);
    if (!made) return made.error();
    std::vector<PassReport>& passes = inputs.report.passes;
    passes.insert(passes.end(), made->report.passes.begin(), made->report.passes.end());
    if (made->diffuse) inputs.sources.reference_diffuse = made->diffuse->handle();
    if (made->specular) inputs.sources.reference_specular = made->specular->handle();
    inputs.references = std::move(*made);
    return Done{};
}

} // namespace

std::vector<RenderMethod> render_methods() {
    return {std::begin(METHODS), std::end(METHODS)};
}

SphereMethod method_for(Quality quality) {
    switch (quality) {
    case Quality::fast: return SphereMethod::one_tap;
    case Quality::normal: return SphereMethod::two_tap;
    case Quality::high: break;
    }
    return SphereMethod::hybrid;
}

Outcome<SphereInputs> make_sphere_inputs(Gpu& gpu, const GpuEnvironment& environment,
                                         const RenderSettings& settings, const Progress& progress) {
    auto plan =
        plan_scene(gpu, environment.cube.description().width, environment.constant, settings);
    if (!plan) return plan.error();
    MapPasses passes(gpu);
    auto maps = SceneMaps::create(passes, environment, *plan);
    if (!maps) return maps.error();
    SphereInputs inputs{
        .plan = std::move(*plan), .passes = std::move(passes), .maps = std::move(*maps)};
    if (const auto made = run(inputs, progress); !made) return made.error();
    if (inputs.plan.shading().method == SphereMethod::reference) {
        const auto made = add_references(inputs, gpu, environment, settings.view, progress);
        if (!made) return made.error();
    }
    inputs.report.images = image_reports(inputs.plan);
    inputs.report.expected_error = inputs.plan.expected_error();
    if (inputs.plan.draws()) inputs.bytes = inputs.plan.passes().back().bytes_read;
    return inputs;
}

} // namespace lobelia::host
