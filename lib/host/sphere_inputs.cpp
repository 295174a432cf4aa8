#include "host/sphere_inputs.h"

#include <lobelia/clipped_tables.h>

#include "host/averages.h"
#include "host/checks.h"
#include "host/irradiance.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/reference.h"

namespace lobelia::host {

namespace {

/// What one method's inputs are made from, and where they go.
struct Making {
    Gpu& gpu;
    const GpuEnvironment& environment;
    const RenderSettings& settings;
    const Progress& progress;
    SphereInputs& inputs;

    const Material& material() const { return settings.view.material; }

    /// For methods that make their inputs in one go.
    Outcome<Done> go_on() const {
        if (progress && !progress(1.0)) return Failure{"cancelled"};
        return Done{};
    }
    VkImageView keep(GpuImage image) const {
        inputs.bytes += image_bytes(image);
        inputs.images.push_back(std::move(image));
        return inputs.images.back().view();
    }
    VkBuffer keep(GpuBuffer buffer) const {
        inputs.bytes += buffer.size();
        inputs.buffers.push_back(std::move(buffer));
        return inputs.buffers.back().handle();
    }
    void add(const WorkReport& more) const {
        WorkReport& report = inputs.report;
        report.passes.insert(report.passes.end(), more.passes.begin(), more.passes.end());
        report.images.insert(report.images.end(), more.images.begin(), more.images.end());
        if (more.suns) report.suns = more.suns;
    }
};

/// Prefilter's maps: one at the material's exponent, and where `lambert` says so one for the
/// diffuse lobe.
Outcome<Done> add_maps(const Making& making, bool lambert) {
    SphereInputs& inputs = making.inputs;
    const std::span<const float> exponents(&making.material().exponent,
                                           inputs.shading.specular ? 1 : 0);
    auto made =
        make_maps(making.gpu, making.environment,
                  {.exponents = exponents, .lambert = lambert, .quality = making.settings.quality},
                  making.progress);
    if (!made) return made.error();
    making.add(made->report);
    inputs.sources.prefilter_state = making.keep(std::move(made->state));
    if (lambert) inputs.sources.diffuse = making.keep(std::move(made->images.back()));
    if (inputs.shading.specular) {
        inputs.shading.specular_filter = made->descriptions.front().filter;
        inputs.sources.specular = making.keep(std::move(made->images.front()));
    }
    return Done{};
}

Outcome<Done> make_split_sum(const Making& making) {
    return add_maps(making, making.inputs.shading.diffuse);
}

Outcome<Done> make_taps(const Making& making, Taps taps) {
    SphereInputs& inputs = making.inputs;
    if (!inputs.shading.specular) { // nothing that the horizon cuts
        inputs.shading.method = SphereMethod::split_sum;
        return make_split_sum(making);
    }
    const float exponent = making.material().exponent;
    auto made = make_maps(making.gpu, making.environment,
                          {.lambert = inputs.shading.diffuse,
                           .ladder = ladder_for(taps, exponent, exponent),
                           .quality = making.settings.quality},
                          making.progress);
    if (!made) return made.error();
    auto tables = make_clipped_tables(making.gpu);
    if (!tables) return tables.error();
    making.add(made->report);
    inputs.shading.suns = made->report.suns > 0u;
    inputs.sources.prefilter_state = making.keep(std::move(made->state));
    inputs.sources.ladder = making.keep(std::move(*made->ladder));
    inputs.sources.clipped_tables = making.keep(std::move(*tables));
    if (inputs.shading.diffuse)
        inputs.sources.diffuse = making.keep(std::move(made->images.back()));
    return Done{};
}

Outcome<Done> make_one_tap(const Making& making) {
    return make_taps(making, Taps::one);
}
Outcome<Done> make_two_tap(const Making& making) {
    return make_taps(making, Taps::two);
}
Outcome<Done> make_hybrid(const Making& making) {
    return make_taps(making, Taps::five);
}

Outcome<Done> make_reference(const Making& making) {
    auto made =
        make_references(making.gpu, making.environment, making.settings.view, making.progress);
    if (!made) return made.error();
    making.add(made->report);
    SphereSources& sources = making.inputs.sources;
    if (made->diffuse) sources.reference_diffuse = making.keep(std::move(*made->diffuse));
    if (made->specular) sources.reference_specular = making.keep(std::move(*made->specular));
    return Done{};
}

/// The environment's mips down to faces of `last_face` texels.
Outcome<VkImageView> add_mips(const Making& making, std::uint32_t last_face, MipWeights weights) {
    auto made = make_mips(making.gpu, making.environment, last_face, weights);
    if (!made) return made.error();
    made->report.images.front().lifetime = "kept";
    making.add(made->report);
    if (const auto wanted = making.go_on(); !wanted) return wanted.error();
    return making.keep(std::move(made->image));
}

constexpr std::uint32_t KURT2019_FACE = 64; // texels

Outcome<Done> make_kurt2019(const Making& making) {
    const auto view = add_mips(making, KURT2019_FACE, MipWeights::equal);
    if (!view) return view.error();
    making.inputs.sources.blurred = *view;
    return Done{};
}

Outcome<Done> make_harmonics(const Making& making) {
    if (making.inputs.shading.diffuse) {
        auto made = make_irradiance(making.gpu, making.environment);
        if (!made) return made.error();
        making.add(made->report);
        making.inputs.sources.irradiance = making.keep(std::move(made->buffer));
    }
    if (making.inputs.shading.specular) return add_maps(making, false);
    return making.go_on();
}

Outcome<Done> make_importance(const Making& making) {
    const auto view = add_mips(making, 1, MipWeights::solid_angle);
    if (!view) return view.error();
    making.inputs.sources.mips = *view;
    return Done{};
}

/// A method of the command line, and what is made for it.
struct Recipe {
    RenderMethod method;
    Outcome<Done> (*make)(const Making&);
};

constexpr Recipe RECIPES[] = {
    {{SphereMethod::kurt2019, "kurt2019",
      "six colours of the environment, as the material's paper"},
     make_kurt2019},
    {{SphereMethod::sh2, "sh2",
      "diffuse by spherical harmonics of degree 2, the rest as split-sum"},
     make_harmonics},
    {{SphereMethod::sh4, "sh4", "the same of degree 4"}, make_harmonics},
    {{SphereMethod::split_sum, "split-sum", "prefiltered maps"}, make_split_sum},
    {{SphereMethod::one_tap, "one-tap", "one lobe for what the horizon leaves of the lobe"},
     make_one_tap},
    {{SphereMethod::two_tap, "two-tap", "two lobes"}, make_two_tap},
    {{SphereMethod::hybrid, "hybrid", "five lobes near the horizon"}, make_hybrid},
    {{SphereMethod::importance, "importance", "filtered importance sampling, N samples a lobe"},
     make_importance},
    {{SphereMethod::reference, "reference",
      "integrates over every texel for every pixel: the ground truth"},
     make_reference},
};

} // namespace

std::vector<RenderMethod> render_methods() {
    std::vector<RenderMethod> methods;
    for (const Recipe& recipe : RECIPES) methods.push_back(recipe.method);
    return methods;
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
    const Material& material = settings.view.material;
    SphereInputs inputs;
    inputs.shading = {.method = settings.method,
                      .diffuse = !is_black(material.diffuse),
                      .specular = !is_black(material.specular),
                      .background = settings.view.background,
                      .samples = settings.samples};
    inputs.sources.background = environment.cube.view();
    if (settings.view.background) inputs.bytes += image_bytes(environment.cube);
    if (!inputs.shading.diffuse && !inputs.shading.specular) {
        // Black by every method: the one that reads the least shows it.
        inputs.shading.method = SphereMethod::plain_split_sum;
        return inputs;
    }
    for (const Recipe& recipe : RECIPES) {
        if (recipe.method.method != settings.method) continue;
        const auto made = recipe.make({gpu, environment, settings, progress, inputs});
        if (!made) return made.error();
        return inputs;
    }
    return Failure{"this method shows maps of its caller's, give one of render_methods()"};
}

} // namespace lobelia::host
