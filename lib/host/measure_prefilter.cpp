#include <lobelia/exact.h>

#include "host/averages.h"
#include "host/importance.h"
#include "host/map_sizes.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/warm_cost.h"

namespace lobelia::host {

namespace {

using Directions = std::span<const std::array<float, 3>>;

constexpr std::uint64_t FACES = 6;
constexpr std::uint64_t TEXEL_BYTES = 4 * sizeof(float);

std::vector<Vector> vectors(Directions directions) {
    std::vector<Vector> axes;
    for (const auto& direction : directions) axes.push_back(to_vector(direction));
    return axes;
}

std::vector<float> colours_of(const std::vector<float>& texels) {
    std::vector<float> colours;
    for (std::size_t i = 0; i < texels.size(); i += 4)
        colours.insert(colours.end(), &texels[i], &texels[i] + 3);
    return colours;
}

Outcome<Measured> measure_chain(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, Directions directions) {
    const auto bound =
        bind_maps(gpu, environment,
                  {.exponents = {settings.exponents.data(), 1}, .quality = settings.quality});
    if (!bound) return bound.error();
    const PrefilterPlan& plan = bound->plan;
    auto cost = warm_cost(gpu, [&](PassReport& report) {
        return run_pass(gpu, report, [&](VkCommandBuffer commands) {
            bound->job.record(commands, 0, plan.pass_count());
        });
    });
    if (!cost) return cost.error();
    cost->dispatches = plan.pass_count();
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i)
        cost->bytes += plan.pass(i).bytes_read + plan.pass(i).bytes_written;

    const auto reader = MapReader::create(gpu.device());
    if (!reader) return core_failure(reader.error());
    const auto values = read_map(gpu, *reader, bound->maps, 0, vectors(directions));
    if (!values) return values.error();
    return Measured{colours_of(values->texels), *cost};
}

/// The edge of the map that the chain makes of this.
Outcome<std::uint32_t> map_face(const PrefilterSettings& settings, std::uint32_t source_face) {
    const auto plan = PrefilterPlan::make({.exponents = {settings.exponents.data(), 1},
                                           .quality = settings.quality,
                                           .source_size = source_face});
    if (!plan) return core_failure(plan.error());
    return plan->maps().front().size;
}

Outcome<Measured> measure_exact(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, std::uint32_t face,
                                Directions directions) {
    const auto exact = Exact::create(gpu.device());
    if (!exact) return core_failure(exact.error());
    const ExactSource source = exact_source(environment);
    std::vector<ExactQuery> queries;
    for (const auto& axis : directions) queries.push_back({.axis = {axis[0], axis[1], axis[2]}});
    const auto averages =
        average(gpu, *exact, source, {.exponent = settings.exponents.front()}, queries, {});
    if (!averages) return averages.error();
    const std::uint64_t texels = FACES * face * face;
    Cost cost = once(averages->report, double(texels) / double(queries.size()));
    cost.bytes = source.bytes + TEXEL_BYTES * texels;
    cost.dispatches = 1;
    return Measured{colours_of(averages->texels), cost};
}

Outcome<Measured> measure_importance(Gpu& gpu, const GpuEnvironment& environment,
                                     const PrefilterSettings& settings, std::uint32_t face,
                                     Directions directions) {
    const bool filtered = settings.method == PrefilterMethod::filtered_importance;
    const auto importance = Importance::create(gpu.device());
    if (!importance) return core_failure(importance.error());
    const std::uint32_t last_face = filtered ? 1 : environment.cube.description().width;
    const auto mips = make_mips(gpu, environment, last_face, MipWeights::solid_angle);
    if (!mips) return mips.error();
    const auto averages_about = [&](std::span<const Vector> axes) {
        return average_by_samples(gpu, *importance, mips->image,
                                  {.exponent = settings.exponents.front(),
                                   .samples = settings.samples,
                                   .filtered = filtered},
                                  axes, {});
    };

    const std::vector<Vector> texels = texel_directions(Layout::cube, face, face);
    auto cost =
        warm_cost(gpu, texels.size(), [&](std::size_t count, PassReport& report) -> Outcome<Done> {
            std::vector<Vector> axes; // evenly spread: neighbours share what is in the caches
            for (std::size_t i = 0; i < count; ++i)
                axes.push_back(texels[i * texels.size() / count]);
            const auto averages = averages_about(axes);
            if (!averages) return averages.error();
            add_times(report, averages->report);
            return Done{};
        });
    if (!cost) return cost.error();
    cost->fetches = settings.samples * texels.size();
    cost->bytes = image_bytes(mips->image) + TEXEL_BYTES * texels.size();
    cost->dispatches = 1;
    const auto averages = averages_about(vectors(directions));
    if (!averages) return averages.error();
    return Measured{colours_of(averages->texels), *cost};
}

} // namespace

Outcome<Measured> measure_prefilter(Gpu& gpu, const GpuEnvironment& environment,
                                    const PrefilterSettings& settings,
                                    std::span<const std::array<float, 3>> directions) {
    if (const auto valid = check_prefilter(settings); !valid) return valid.error();
    if (directions.empty()) return Failure{"no direction is given, give at least one"};
    if (settings.method == PrefilterMethod::chain)
        return measure_chain(gpu, environment, settings, directions);
    const auto face = map_face(settings, prefilter_face(environment.cube.description().width));
    if (!face) return face.error();
    return settings.method == PrefilterMethod::exact
               ? measure_exact(gpu, environment, settings, *face, directions)
               : measure_importance(gpu, environment, settings, *face, directions);
}

} // namespace lobelia::host
