#include "host/sphere_inputs.h"

#include "host/averages.h"
#include "host/irradiance.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/reference.h"

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

/// What the plan asks for is made from this, and goes there.
struct Making {
    Gpu& gpu;
    const GpuEnvironment& environment;
    const RenderSettings& settings;
    const Progress& progress;
    SphereInputs& inputs;

    /// For what is made in one go.
    Outcome<Done> go_on() const {
        if (progress && !progress(1.0)) return Failure{"cancelled"};
        return Done{};
    }
    VkImageView keep(GpuImage image) const {
        inputs.images.push_back(std::move(image));
        return inputs.images.back().view();
    }
    VkBuffer keep(GpuBuffer buffer) const {
        inputs.buffers.push_back(std::move(buffer));
        return inputs.buffers.back().handle();
    }
    void add(const WorkReport& more) const {
        WorkReport& report = inputs.report;
        report.passes.insert(report.passes.end(), more.passes.begin(), more.passes.end());
        if (more.suns) report.suns = more.suns;
    }
};

Outcome<Done> make_prefiltered(const Making& making, const PrefilterPlan& plan) {
    SphereInputs& inputs = making.inputs;
    auto made = make_maps(making.gpu, making.environment, plan, making.progress);
    if (!made) return made.error();
    making.add(made->report);
    inputs.sources.prefilter_state = making.keep(std::move(made->state));
    const bool has_lambert = inputs.shading.diffuse && !inputs.sources.irradiance;
    for (std::size_t i = 0; i < made->images.size(); ++i) {
        const bool diffuse = has_lambert && i + 1 == made->images.size();
        (diffuse ? inputs.sources.diffuse : inputs.sources.specular) =
            making.keep(std::move(made->images[i]));
    }
    if (!made->ladder) return Done{};
    inputs.shading.suns = made->report.suns > 0u;
    inputs.sources.ladder = making.keep(std::move(*made->ladder));
    PassReport upload = report_of(*find_pass(inputs.plan, "clipped tables"));
    auto tables = make_clipped_tables(making.gpu, upload);
    if (!tables) return tables.error();
    making.add({.passes = {upload}});
    inputs.sources.clipped_tables = making.keep(std::move(*tables));
    return Done{};
}

Outcome<Done> make_irradiance_coefficients(const Making& making) {
    auto made = make_irradiance(making.gpu, making.environment);
    if (!made) return made.error();
    making.add(made->report);
    making.inputs.sources.irradiance = making.keep(std::move(made->buffer));
    return making.go_on();
}

/// The environment's mips down to faces of `last_face` texels.
Outcome<VkImageView> add_mips(const Making& making, std::uint32_t last_face, MipWeights weights) {
    auto made = make_mips(making.gpu, making.environment, last_face, weights);
    if (!made) return made.error();
    making.add(made->report);
    if (const auto wanted = making.go_on(); !wanted) return wanted.error();
    return making.keep(std::move(made->image));
}

Outcome<Done> add_references(const Making& making) {
    auto made =
        make_references(making.gpu, making.environment, making.settings.view, making.progress);
    if (!made) return made.error();
    making.add(made->report);
    SphereSources& sources = making.inputs.sources;
    if (made->diffuse) sources.reference_diffuse = making.keep(std::move(*made->diffuse));
    if (made->specular) sources.reference_specular = making.keep(std::move(*made->specular));
    return Done{};
}

Outcome<Done> make_planned(const Making& making) {
    SphereInputs& inputs = making.inputs;
    const ScenePlan& plan = inputs.plan;
    SphereSources& sources = inputs.sources;
    sources.background = making.environment.cube.view();
    if (plan.environment_is_its_maps()) sources.diffuse = sources.specular = sources.background;
    if (find_pass(plan, "irradiance"))
        if (const auto made = make_irradiance_coefficients(making); !made) return made.error();
    if (plan.prefilter()) return make_prefiltered(making, *plan.prefilter());
    if (plan.shading().method == SphereMethod::reference) return add_references(making);
    const auto add = [&](VkImageView SphereSources::*view, std::uint32_t last_face,
                         MipWeights weights) -> Outcome<Done> {
        const auto made = add_mips(making, last_face, weights);
        if (!made) return made.error();
        sources.*view = *made;
        return Done{};
    };
    if (plan.shading().method == SphereMethod::kurt2019)
        return add(&SphereSources::blurred, ScenePlan::KURT2019_FACE, MipWeights::equal);
    if (plan.shading().method == SphereMethod::importance)
        return add(&SphereSources::mips, 1, MipWeights::solid_angle);
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
    SphereInputs inputs{.plan = std::move(*plan)};
    inputs.shading = inputs.plan.shading();
    if (const auto made = make_planned({gpu, environment, settings, progress, inputs}); !made)
        return made.error();
    inputs.report.images = image_reports(inputs.plan);
    if (inputs.plan.draws()) inputs.bytes = inputs.plan.passes().back().bytes_read;
    return inputs;
}

} // namespace lobelia::host
