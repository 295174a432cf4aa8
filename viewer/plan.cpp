#include <algorithm>
#include <cstdio>
#include <memory>

#include <lobelia/host/plan.h>

#include "environment.h"
#include "gpu_choice.h"
#include "messages.h"
#include "numbers.h"
#include "parsed_option.h"
#include "plan_table.h"
#include "prefilter_method.h"
#include "quality.h"
#include "report.h"
#include "sphere_options.h"
#include "tolerance.h"
#include "verbs.h"

namespace lobelia::cli {

namespace {

struct PlanOptions {
    std::string environment;
    SphereOptions sphere;
    std::vector<float> exponents;
    bool lambert = false;
    GpuChoice gpu;
    bool why = false;
    bool json = false;

    bool of_prefilter() const { return lambert || !exponents.empty(); }
};

host::PrefilterSettings prefilter_settings(const PlanOptions& options) {
    host::PrefilterSettings settings{.quality = options.sphere.quality.value_or(Quality::normal),
                                     .exponents = options.exponents};
    if (options.lambert) settings.exponents.insert(settings.exponents.begin(), 1.0f);
    settings.width = options.sphere.face;
    return settings;
}

/// Work, and what it is done by.
struct Planned {
    host::WorkPlan work;
    std::string method;
    Quality quality = Quality::normal;
};

Outcome<Planned> plan_maps(const PlanOptions& options, host::Gpu& gpu,
                           const host::EnvironmentShape& environment) {
    host::PrefilterSettings settings = prefilter_settings(options);
    if (const auto met = meet(options.sphere.tolerance, gpu, environment, settings); !met)
        return met.error();
    const auto rates = host::measure_rates(gpu, settings);
    if (!rates) return rates.error();
    auto work = host::plan_prefilter(gpu, environment, settings, *rates);
    if (!work) return work.error();
    return Planned{std::move(*work), prefilter_method_name(settings.method), settings.quality};
}

Outcome<Planned> plan_sphere(const PlanOptions& options, host::Gpu& gpu,
                             const host::EnvironmentShape& environment) {
    host::RenderSettings settings = settings_of(options.sphere);
    if (const auto refused =
            host::check_material(settings.view.material, options.sphere.allow_energy_gain))
        return *refused;
    if (const auto met = meet(options.sphere.tolerance, gpu, environment, settings); !met)
        return met.error();
    const auto rates = host::measure_rates(gpu, settings);
    if (!rates) return rates.error();
    auto work = host::plan_render(gpu, environment, options.sphere.face, settings, *rates);
    if (!work) return work.error();
    return Planned{std::move(*work), method_name(settings.method), settings.quality};
}

Outcome<std::string> plan(const PlanOptions& options) {
    Report report;
    ProgressLine progress;
    const auto source = read_source(options.environment, progress);
    if (!source) return source.error();
    auto gpu = start_gpu(options.gpu);
    if (!gpu) return gpu.error();
    if (const auto fits = check_face(*source, options.sphere.face); !fits) return fits.error();
    progress.begin("timing the device");
    const host::EnvironmentShape shape = shape_of(*source);
    const auto planned = options.of_prefilter() ? plan_maps(options, *gpu, shape)
                                                : plan_sphere(options, *gpu, shape);
    if (!planned) return planned.error();
    const host::WorkPlan& work = planned->work;

    report.gpu = gpu->description();
    report.method = planned->method;
    const auto& images = work.report.images;
    const bool prefiltered = std::any_of(images.begin(), images.end(), [](const auto& image) {
        return image.name.starts_with("map n=") || image.name.starts_with("ladder from");
    });
    if (prefiltered) report.quality = planned->quality;
    if (*source) report.sanitised = (*source)->sanitised;
    report.append(work.report);
    if (options.json) return options.why ? as_json(report, work.reasons) : as_json(report);
    return plan_table(work) + (options.why ? reasons_table(work) : "");
}

int plan_verb(const PlanOptions& options) {
    const Outcome<std::string> text = plan(options);
    if (!text) return fail(text.error().message);
    return print(*text);
}

void check_usage(const PlanOptions& options) {
    check_usage(options.sphere);
    if (options.of_prefilter() && options.sphere.method)
        throw CLI::ValidationError("--method", "is of a render's plan; leave out --exponents");
}

} // namespace

void add_plan(CLI::App& program, int& status) {
    const auto options = std::make_shared<PlanOptions>();
    CLI::App* const verb = program.add_subcommand(
        "plan", "prints what a render or prefilter would record, and what it would cost");
    verb->add_option("ENV", options->environment,
                     "environment map, OpenEXR or Radiance .hdr; default: a built-in one");
    add_sphere_options(*verb, options->sphere);
    add_tolerance(*verb, options->sphere.tolerance);
    add_parsed(*verb, "--exponents", parse_exponents, &options->exponents, "X,X,...",
               "plan a prefilter of these exponents, and no render");
    verb->add_flag("--lambert", options->lambert, "likewise, with the diffuse lobe");
    verb->add_flag("--why", options->why,
                   "for each effect, why it is in or out and what it costs, or would");
    add_gpu_options(*verb, options->gpu);
    verb->add_flag("--json", options->json, "print one JSON object, as render and prefilter do");
    verb->callback([options, &status] {
        check_usage(*options);
        status = plan_verb(*options);
    });
}

} // namespace lobelia::cli
