#include <lobelia/host/plan.h>

#include "host/averages.h"
#include "host/environment_plan.h"
#include "host/importance.h"
#include "host/map_sizes.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/plan_reasons.h"
#include "host/scene_plan.h"
#include "host/text.h"

namespace lobelia::host {

namespace {

std::uint64_t texels_of(Layout layout, const MapSize& size) {
    return std::uint64_t(size.width) * size.height * (layout == Layout::cube ? 6 : 1);
}

/// Work under way, with what its passes' times are in proportion to.
struct Draft {
    WorkReport report;
    std::vector<double> work;

    void add(const PassReport& pass, double its_work) {
        report.passes.push_back(pass);
        work.push_back(its_work);
    }
    void add(const EnvironmentPlan& environment) {
        report = environment.report;
        work = environment.work;
    }
    void add(const std::vector<ImageReport>& images) {
        report.images.insert(report.images.end(), images.begin(), images.end());
    }
    /// Fills in the times.
    WorkReport predicted(const Gpu& gpu, const Rates& rates) && {
        if (rates.empty()) return std::move(report);
        const bool cpu = gpu.description().type == "cpu";
        for (std::size_t i = 0; i < work.size(); ++i) {
            PassReport& pass = report.passes[i];
            (cpu ? pass.cpu_ms : pass.gpu_ms) = predicted_milliseconds(rates, pass.name, work[i]);
        }
        return std::move(report);
    }
};

void add_chain(Draft& draft, const PrefilterPlan& plan, const PrefilterSettings& settings) {
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i) {
        const PrefilterPass pass = plan.pass(i);
        draft.add({.name = pass.name,
                   .invocations = pass.invocations,
                   .bytes_read = pass.bytes_read,
                   .bytes_written = pass.bytes_written},
                  pass.work);
    }
    const std::vector<ImageReport> images = map_reports(plan);
    draft.add(images);
    const std::vector<MapSize> sizes = map_sizes(settings);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::uint64_t count = texels_of(settings.layout, sizes[i]);
        draft.add(read_map_pass(images[i].bytes, count), double(count));
    }
}

void add_by_texel(Draft& draft, const EnvironmentShape& environment, std::uint32_t face,
                  const Gpu& gpu, const PrefilterSettings& settings) {
    const std::vector<MapSize> sizes = map_sizes(settings);
    const bool exact = settings.method == PrefilterMethod::exact;
    const bool filtered = settings.method == PrefilterMethod::filtered_importance;
    const WorkReport mips = mips_report(gpu, face, filtered ? 1 : face);
    if (!exact) {
        draft.add(mips.passes.front(), double(mips.passes.front().invocations));
        draft.add(mips.images);
    }
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::uint64_t count = texels_of(settings.layout, sizes[i]);
        const std::uint64_t source = source_bytes(environment);
        if (exact) {
            const PassReport pass = exact_pass("exact", source, count);
            draft.add(pass, exact_work(pass, settings.exponents[i]));
        } else
            draft.add(importance_pass(filtered, mips.images.front().bytes, count),
                      double(count) * settings.samples);
    }
}

} // namespace

double predicted_milliseconds(const Rates& rates, const std::string& name, double work) {
    const auto found = rates.find(name);
    return found == rates.end() ? 0.0 : found->second * work;
}

Outcome<WorkPlan> plan_render(const Gpu& gpu, const EnvironmentShape& environment,
                              std::uint32_t face, const RenderSettings& settings,
                              const Rates& rates) {
    if (const auto valid = check_render(gpu, settings); !valid) return valid.error();
    const EnvironmentPlan around = plan_environment(environment, face, settings.quality);
    const auto plan = plan_scene(gpu, around.face, environment.constant, settings);
    if (!plan) return plan.error();
    Draft draft;
    draft.add(around);
    const std::uint64_t source = source_bytes(environment);
    for (const PassReport& pass : reference_passes(*plan, settings.view, source))
        draft.add(pass, exact_work(pass, pass.name == "diffuse reference"
                                             ? 1.0f
                                             : settings.view.material.exponent));
    for (const ScenePass& pass : plan->passes()) draft.add(report_of(pass), pass.work);
    draft.add(image_reports(*plan));
    WorkPlan work{std::move(draft).predicted(gpu, rates), {}};
    work.report.expected_error = plan->expected_error();
    if (environment.constant) work.report.suns = 0;
    auto reasons = render_reasons(gpu, {around.face, environment.constant}, settings, rates);
    if (!reasons) return reasons.error();
    work.reasons = std::move(*reasons);
    return work;
}

Outcome<WorkPlan> plan_prefilter(const Gpu& gpu, const EnvironmentShape& environment,
                                 const PrefilterSettings& settings, const Rates& rates) {
    if (const auto valid = check_prefilter(settings); !valid) return valid.error();
    const EnvironmentPlan around = plan_environment(environment, 0, settings.quality);
    Draft draft;
    draft.add(around);
    draft.report.expected_error = expected_error(settings, prefilter_face(around.face));
    if (settings.method != PrefilterMethod::chain) {
        add_by_texel(draft, environment, prefilter_face(around.face), gpu, settings);
        return WorkPlan{std::move(draft).predicted(gpu, rates), {}};
    }
    const auto plan = PrefilterPlan::make({.exponents = settings.exponents,
                                           .quality = settings.quality,
                                           .source_size = prefilter_face(around.face)});
    if (!plan) return core_failure(plan.error());
    add_chain(draft, *plan, settings);
    WorkPlan work{std::move(draft).predicted(gpu, rates), {}};
    auto reasons = prefilter_reasons(prefilter_face(around.face), settings, rates);
    if (!reasons) return reasons.error();
    work.reasons = std::move(*reasons);
    return work;
}

} // namespace lobelia::host
