#include <cstring>

#include <lobelia/exact.h>
#include <lobelia/host/work.h>
#include <lobelia/map_reader.h>

#include "host/averages.h"
#include "host/checks.h"
#include "host/directions.h"
#include "host/importance.h"
#include "host/map_sizes.h"
#include "host/maps.h"
#include "host/mips.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t MOST_SAMPLES = 65535;

Outcome<Done> check(const PrefilterSettings& settings) {
    if (settings.exponents.empty()) return Failure{"no exponent is given, give at least one"};
    for (const float exponent : settings.exponents)
        if (const auto refused = check_exponent(exponent)) return *refused;
    if (const auto valid = check_sizes(settings); !valid) return valid.error();
    if (settings.samples < 1 || settings.samples > MOST_SAMPLES)
        return Failure{"there are " + std::to_string(settings.samples) + " samples, give 1 to " +
                       std::to_string(MOST_SAMPLES)};
    return Done{};
}

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

/// The values of one prefiltered map at the texel centres of an image.
Outcome<Image> read_map(Gpu& gpu, const MapReader& reader, const PrefilteredMaps& maps,
                        std::size_t index, Layout layout, const MapSize& size, PassReport& run) {
    std::vector<float> directions;
    for (const Vector& axis : texel_directions(layout, size.width, size.height))
        directions.insert(directions.end(), {float(axis.x), float(axis.y), float(axis.z), 0.0f});
    const VkDeviceSize bytes = directions.size() * sizeof(float);
    auto input = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!input) return input.error();
    std::memcpy(input->data(), directions.data(), bytes);
    auto output = gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, Memory::host);
    if (!output) return output.error();
    const auto job = reader.bind({.map = maps.descriptions[index],
                                  .view = maps.images[index].view(),
                                  .state = maps.state.handle(),
                                  .directions = input->handle(),
                                  .results = output->handle(),
                                  .count = std::uint32_t(directions.size() / 4)});
    if (!job) return core_failure(job.error());
    const auto done = run_pass(gpu, run, [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    run.invocations = directions.size() / 4;
    run.bytes_read = bytes + image_bytes(maps.images[index]);
    run.bytes_written = bytes;
    std::memcpy(directions.data(), output->data(), bytes);
    return map_image(layout, size, std::move(directions));
}

Outcome<Prefiltering> by_chain(Gpu& gpu, const GpuEnvironment& environment,
                               const PrefilterSettings& settings, const Progress& progress) {
    const auto maps =
        make_maps(gpu, environment, {.exponents = settings.exponents, .quality = settings.quality},
                  share(progress, 0.0, 0.5));
    if (!maps) return maps.error();
    const auto reader = MapReader::create(gpu.device());
    if (!reader) return core_failure(reader.error());
    const std::vector<MapSize> sizes = map_sizes(settings);
    const double count = double(settings.exponents.size());
    Prefiltering result{{}, maps->report};
    for (std::size_t i = 0; i < settings.exponents.size(); ++i) {
        PassReport run{.name = "read map"};
        auto image = read_map(gpu, *reader, *maps, i, settings.layout, sizes[i], run);
        if (!image) return image.error();
        result.maps.push_back(std::move(*image));
        result.report.passes.push_back(run);
        if (progress && !progress(0.5 + 0.5 * double(i + 1) / count)) return Failure{"cancelled"};
    }
    return result;
}

} // namespace

Outcome<Prefiltering> prefilter(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, const Progress& progress) {
    if (const auto valid = check(settings); !valid) return valid.error();
    switch (settings.method) {
    case PrefilterMethod::chain: break;
    case PrefilterMethod::importance:
    case PrefilterMethod::filtered_importance:
        return by_importance(gpu, environment, settings, progress);
    case PrefilterMethod::exact: return by_exact(gpu, environment, settings, progress);
    }
    return by_chain(gpu, environment, settings, progress);
}

} // namespace lobelia::host
