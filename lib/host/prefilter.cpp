#include <lobelia/exact.h>
#include <lobelia/host/work.h>

#include "host/averages.h"
#include "host/directions.h"
#include "host/guard.h"
#include "host/importance.h"
#include "host/map_sizes.h"
#include "host/maps.h"
#include "host/mips.h"

namespace lobelia::host {

namespace {

Image map_image(Layout layout, const MapSize& size, std::vector<float> texels) {
    return {layout, size.width, size.height, layout == Layout::cube ? 6u : 1u, std::move(texels)};
}

/// Averages about these axes, R G B 1 each.
using Averager = std::function<Outcome<Averages>(float exponent, const std::vector<Vector>& axes,
                                                 const Progress& progress)>;

/// Makes each map by averaging about its texels' directions.
Outcome<Prefiltering> by_texel(const PrefilterSettings& settings, const Progress& progress,
                               const Averager& averages_of) {
    const std::vector<MapSize> sizes = map_sizes(settings);
    const double count = double(settings.exponents.size());
    Prefiltering result;
    for (std::size_t i = 0; i < settings.exponents.size(); ++i) {
        const float exponent = settings.exponents[i];
        const MapSize& size = sizes[i];
        auto averages =
            averages_of(exponent, texel_directions(settings.layout, size.width, size.height),
                        share(progress, double(i) / count, double(i + 1) / count));
        if (!averages) return averages.error();
        result.maps.push_back(map_image(settings.layout, size, std::move(averages->texels)));
        result.report.passes.push_back(averages->report);
    }
    return result;
}

Outcome<Prefiltering> by_exact(Gpu& gpu, const GpuEnvironment& environment,
                               const PrefilterSettings& settings, const Progress& progress) {
    const auto exact = Exact::create(gpu.device());
    if (!exact) return core_failure(exact.error());
    const ExactSource source = exact_source(environment);
    return by_texel(
        settings, progress,
        [&](float exponent, const std::vector<Vector>& axes, const Progress& part) {
            std::vector<ExactQuery> queries;
            for (const Vector& axis : axes)
                queries.push_back({.axis = {float(axis.x), float(axis.y), float(axis.z)}});
            return average(gpu, *exact, source, {.exponent = exponent}, queries, part);
        });
}

Outcome<Prefiltering> by_importance(Gpu& gpu, const GpuEnvironment& environment,
                                    const PrefilterSettings& settings, const Progress& progress) {
    const bool filtered = settings.method == PrefilterMethod::filtered_importance;
    const auto importance = Importance::create(gpu.device());
    if (!importance) return core_failure(importance.error());
    // All levels for filtered sampling, else level 0 alone.
    const std::uint32_t last_face = filtered ? 1 : environment.cube.description().width;
    const auto mips = make_mips(gpu, environment, last_face, MipWeights::solid_angle);
    if (!mips) return mips.error();
    auto result =
        by_texel(settings, progress,
                 [&](float exponent, const std::vector<Vector>& axes, const Progress& part) {
                     return average_by_samples(
                         gpu, *importance, mips->image,
                         {.exponent = exponent, .samples = settings.samples, .filtered = filtered},
                         axes, part);
                 });
    if (!result) return result.error();
    WorkReport& report = result->report;
    report.passes.insert(report.passes.begin(), mips->report.passes.begin(),
                         mips->report.passes.end());
    report.images = mips->report.images;
    return result;
}

Outcome<Prefiltering> by_chain(Gpu& gpu, const GpuEnvironment& environment,
                               const PrefilterSettings& settings, const Progress& progress) {
    const auto plan =
        PrefilterPlan::make({.exponents = settings.exponents,
                             .quality = settings.quality,
                             .source_size = environment.source().description().width});
    if (!plan) return core_failure(plan.error());
    const auto maps = make_maps(gpu, environment, *plan, share(progress, 0.0, 0.5));
    if (!maps) return maps.error();
    const auto reader = MapReader::create(gpu.device());
    if (!reader) return core_failure(reader.error());
    const std::vector<MapSize> sizes = map_sizes(settings);
    const double count = double(settings.exponents.size());
    Prefiltering result{{}, maps->report};
    for (std::size_t i = 0; i < settings.exponents.size(); ++i) {
        const MapSize& size = sizes[i];
        auto values = read_map(gpu, *reader, *maps, i,
                               texel_directions(settings.layout, size.width, size.height));
        if (!values) return values.error();
        result.maps.push_back(map_image(settings.layout, size, std::move(values->texels)));
        result.report.passes.push_back(values->report);
        if (progress && !progress(0.5 + 0.5 * double(i + 1) / count)) return Failure{"cancelled"};
    }
    return result;
}

Outcome<Prefiltering> by_method(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, const Progress& progress) {
    switch (settings.method) {
    case PrefilterMethod::chain: break;
    case PrefilterMethod::importance:
    case PrefilterMethod::filtered_importance:
        return by_importance(gpu, environment, settings, progress);
    case PrefilterMethod::exact: return by_exact(gpu, environment, settings, progress);
    }
    return by_chain(gpu, environment, settings, progress);
}

Outcome<Prefiltering> make_prefiltering(Gpu& gpu, const GpuEnvironment& environment,
                                        const PrefilterSettings& settings,
                                        const Progress& progress) {
    if (const auto valid = check_prefilter(settings); !valid) return valid.error();
    auto made = by_method(gpu, environment, settings, progress);
    if (made)
        made->report.expected_error =
            expected_error(settings, environment.source().description().width);
    return made;
}

} // namespace

Outcome<Prefiltering> prefilter(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, const Progress& progress) {
    return guarded([&] { return make_prefiltering(gpu, environment, settings, progress); });
}

} // namespace lobelia::host
