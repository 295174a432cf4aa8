#include <lobelia/exact.h>

#include "host/averages.h"
#include "host/importance.h"
#include "host/map_sizes.h"
#include "host/maps.h"
#include "host/mips.h"
#include "host/sizes.h"
#include "host/warm_cost.h"

namespace lobelia::host {

namespace {

using Directions = std::span<const std::array<float, 3>>;

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

Outcome<Untimed> by_chain(Gpu& gpu, const GpuEnvironment& environment,
                          const PrefilterSettings& settings, Directions directions) {
    auto made =
        bind_maps(gpu, environment,
                  {.exponents = {settings.exponents.data(), 1}, .quality = settings.quality});
    if (!made) return made.error();
    const auto bound = std::make_shared<MapsJob>(std::move(*made));
    const TimedWork work{[&gpu, bound](PassReport& report) {
        return run_pass(gpu, report, [&](VkCommandBuffer commands) {
            bound->job.record(commands, 0, bound->plan.pass_count());
        });
    }};
    PassReport first;
    if (const auto done = work.run(first); !done) return done.error();
    Cost cost{.dispatches = bound->plan.pass_count()};
    for (std::uint32_t i = 0; i < bound->plan.pass_count(); ++i)
        cost.bytes += bound->plan.pass(i).bytes_read + bound->plan.pass(i).bytes_written;

    const auto reader = MapReader::create(gpu.device());
    if (!reader) return core_failure(reader.error());
    const auto values = read_map(gpu, *reader, bound->maps, 0, vectors(directions));
    if (!values) return values.error();
    return Untimed{{colours_of(values->texels), cost}, work};
}

/// The edge of the map that the chain makes of this.
Outcome<std::uint32_t> map_face(const PrefilterSettings& settings, std::uint32_t source_face) {
    const auto plan = PrefilterPlan::make({.exponents = {settings.exponents.data(), 1},
                                           .quality = settings.quality,
                                           .source_size = source_face});
    if (!plan) return core_failure(plan.error());
    return plan->maps().front().size;
}

Outcome<Untimed> exactly(Gpu& gpu, const GpuEnvironment& environment,
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
    const std::uint64_t texels = cube_texels(face);
    Cost cost = once(averages->report, double(texels) / double(queries.size()));
    cost.bytes = source.bytes + TEXEL_BYTES * texels;
    cost.dispatches = 1;
    return Untimed{{colours_of(averages->texels), cost}, std::nullopt};
}

/// Averages by sampling, about whatever axes.
struct Sampler {
    Importance importance;
    EnvironmentMips mips;
    ImportanceSettings settings;

    Outcome<Averages> about(Gpu& gpu, std::span<const Vector> axes) const {
        return average_by_samples(gpu, importance, mips.image, settings, axes, {});
    }
};

Outcome<Untimed> by_samples(Gpu& gpu, const GpuEnvironment& environment,
                            const PrefilterSettings& settings, std::uint32_t face,
                            Directions directions) {
    const bool filtered = settings.method == PrefilterMethod::filtered_importance;
    auto importance = Importance::create(gpu.device());
    if (!importance) return core_failure(importance.error());
    const std::uint32_t last_face = filtered ? 1 : environment.cube.description().width;
    auto mips = make_mips(gpu, environment, last_face, MipWeights::solid_angle);
    if (!mips) return mips.error();
    const auto sampler = std::make_shared<Sampler>(Sampler{std::move(*importance),
                                                           std::move(*mips),
                                                           {.exponent = settings.exponents.front(),
                                                            .samples = settings.samples,
                                                            .filtered = filtered}});
    const auto averages = sampler->about(gpu, vectors(directions));
    if (!averages) return averages.error();

    const std::vector<Vector> texels = texel_directions(Layout::cube, face, face);
    const auto work = part_of(
        gpu, texels.size(),
        [&gpu, sampler, texels](std::size_t count, PassReport& report) -> Outcome<Done> {
            std::vector<Vector> axes; // evenly spread: neighbours share what is in the caches
            for (std::size_t i = 0; i < count; ++i)
                axes.push_back(texels[i * texels.size() / count]);
            const auto made = sampler->about(gpu, axes);
            if (!made) return made.error();
            add_times(report, made->report);
            return Done{};
        });
    if (!work) return work.error();
    return Untimed{{colours_of(averages->texels),
                    {.fetches = settings.samples * texels.size(),
                     .bytes = image_bytes(sampler->mips.image) + TEXEL_BYTES * texels.size(),
                     .dispatches = 1}},
                   *work};
}

Outcome<Untimed> prefilter(Gpu& gpu, const PrefilterCase& one, Directions directions) {
    const auto& [environment, settings] = one;
    if (const auto valid = check_prefilter(settings); !valid) return valid.error();
    if (settings.method == PrefilterMethod::chain)
        return by_chain(gpu, *environment, settings, directions);
    const auto face = map_face(settings, environment->source().description().width);
    if (!face) return face.error();
    return settings.method == PrefilterMethod::exact
               ? exactly(gpu, *environment, settings, *face, directions)
               : by_samples(gpu, *environment, settings, *face, directions);
}

} // namespace

Outcome<std::vector<Measured>> measure_prefilter(Gpu& gpu, std::span<const PrefilterCase> cases,
                                                 std::span<const std::array<float, 3>> directions) {
    if (directions.empty()) return Failure{"no direction is given, give at least one"};
    std::vector<Untimed> methods;
    for (const PrefilterCase& one : cases) {
        auto method = prefilter(gpu, one, directions);
        if (!method) return method.error();
        methods.push_back(std::move(*method));
    }
    return add_warm_costs(gpu, std::move(methods));
}

} // namespace lobelia::host
