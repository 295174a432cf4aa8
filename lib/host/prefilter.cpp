#include <algorithm>

#include <lobelia/exact.h>
#include <lobelia/host/work.h>

#include "host/averages.h"
#include "host/checks.h"
#include "host/directions.h"
#include "host/lobe_map.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LARGEST_SIDE = 16384;
constexpr std::uint32_t LARGEST_DEFAULT_FACE = 256;
constexpr std::uint32_t LEAST_DEFAULT_FACE = 32;

struct Size {
    std::uint32_t width, height;
};

Size size_for(const PrefilterSettings& settings, float exponent) {
    const std::uint32_t face =
        std::max(lobe_face(exponent, LARGEST_DEFAULT_FACE), LEAST_DEFAULT_FACE);
    if (settings.layout == Layout::cube) {
        const std::uint32_t width = settings.width ? settings.width : face;
        return {width, width};
    }
    const std::uint32_t width = settings.width ? settings.width : 4 * face;
    return {width, settings.height ? settings.height : std::max(width / 2, 1u)};
}

Outcome<Done> check(const PrefilterSettings& settings) {
    if (settings.exponents.empty()) return Failure{"no exponent is given, give at least one"};
    for (const float exponent : settings.exponents)
        if (const auto refused = check_exponent(exponent)) return *refused;
    if (settings.width > LARGEST_SIDE || settings.height > LARGEST_SIDE)
        return Failure{"a map's size is " + std::to_string(settings.width) + "x" +
                       std::to_string(std::max(settings.height, 1u)) +
                       ", give sides of 1 to 16384 texels"};
    return Done{};
}

std::vector<ExactQuery> lobe_queries(Layout layout, const Size& size) {
    std::vector<ExactQuery> queries;
    for (const Vector& axis : texel_directions(layout, size.width, size.height))
        queries.push_back({.axis = {float(axis.x), float(axis.y), float(axis.z)}});
    return queries;
}

} // namespace

Outcome<Prefiltering> prefilter(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, const Progress& progress) {
    if (const auto valid = check(settings); !valid) return valid.error();
    const auto exact = Exact::create(gpu.device());
    if (!exact) return core_failure(exact.error());

    const ExactSource source = exact_source(environment);
    const double count = double(settings.exponents.size());
    Prefiltering result;
    for (std::size_t i = 0; i < settings.exponents.size(); ++i) {
        const float exponent = settings.exponents[i];
        const Size size = size_for(settings, exponent);
        const auto queries = lobe_queries(settings.layout, size);
        auto averages = average(gpu, *exact, source, {.exponent = exponent}, queries,
                                share(progress, double(i) / count, double(i + 1) / count));
        if (!averages) return averages.error();
        const std::uint32_t layers = settings.layout == Layout::cube ? 6 : 1;
        result.maps.push_back(
            {settings.layout, size.width, size.height, layers, std::move(averages->texels)});
        result.report.passes.push_back(averages->report);
    }
    return result;
}

} // namespace lobelia::host
