#include "host/map_sizes.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "host/checks.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t MOST_SAMPLES = 65535;
constexpr std::uint32_t LARGEST_SIDE = 16384;
constexpr std::uint32_t LARGEST_DEFAULT_FACE = 256;
constexpr std::uint32_t LEAST_DEFAULT_FACE = 32;

/// Two texels for each standard deviation 1 / sqrt(n) of the lobe.
std::uint32_t lobe_face(float exponent) {
    const auto texels = std::uint32_t(std::ceil(4.0 * std::sqrt(double(exponent))));
    return std::clamp(std::bit_ceil(texels), LEAST_DEFAULT_FACE, LARGEST_DEFAULT_FACE);
}

MapSize size_for(const PrefilterSettings& settings, float exponent) {
    const std::uint32_t face = lobe_face(exponent);
    if (settings.layout == Layout::cube) {
        const std::uint32_t width = settings.width ? settings.width : face;
        return {width, width};
    }
    const std::uint32_t width = settings.width ? settings.width : 4 * face;
    return {width, settings.height ? settings.height : std::max(width / 2, 1u)};
}

/// The least face of which no level is smaller than its lobe's map would be alone, as far as the
/// largest goes that is made unasked.
std::uint32_t first_level_face(const std::vector<float>& exponents) {
    std::uint32_t face = LEAST_DEFAULT_FACE;
    for (std::size_t k = 0; k < exponents.size() && face < LARGEST_DEFAULT_FACE; ++k)
        face = std::max(face, lobe_face(exponents[k]) << k);
    return std::min(face, LARGEST_DEFAULT_FACE);
}

std::vector<MapSize> level_sizes(const PrefilterSettings& settings) {
    std::uint32_t face = settings.width ? settings.width : first_level_face(settings.exponents);
    std::vector<MapSize> sizes;
    for (std::size_t k = 0; k < settings.exponents.size(); ++k, face /= 2)
        sizes.push_back({face, face});
    return sizes;
}

Outcome<Done> check_levels(const PrefilterSettings& settings) {
    if (settings.layout != Layout::cube)
        return Failure{"levels belong to a cube map, and the layout is latlong"};
    const std::vector<MapSize> sizes = level_sizes(settings);
    if (sizes.back().width > 0) return Done{};
    const std::uint32_t face = sizes.front().width;
    return Failure{std::to_string(sizes.size()) + " exponents need as many levels, but a face of " +
                   std::to_string(face) + " texels has " + std::to_string(std::bit_width(face)) +
                   ", give a larger face or fewer exponents"};
}

Outcome<Done> check_sizes(const PrefilterSettings& settings) {
    if (settings.width > LARGEST_SIDE || settings.height > LARGEST_SIDE)
        return Failure{"a map's size is " + std::to_string(settings.width) + "x" +
                       std::to_string(std::max(settings.height, 1u)) +
                       ", give sides of 1 to 16384 texels"};
    return settings.levels ? check_levels(settings) : Done{};
}

} // namespace

std::vector<MapSize> map_sizes(const PrefilterSettings& settings) {
    if (settings.levels) return level_sizes(settings);
    std::vector<MapSize> sizes;
    for (const float exponent : settings.exponents) sizes.push_back(size_for(settings, exponent));
    return sizes;
}

Outcome<Done> check_prefilter(const PrefilterSettings& settings) {
    if (settings.exponents.empty()) return Failure{"no exponent is given, give at least one"};
    for (const float exponent : settings.exponents)
        if (const auto refused = check_exponent(exponent)) return *refused;
    if (settings.samples < 1 || settings.samples > MOST_SAMPLES)
        return Failure{"there are " + std::to_string(settings.samples) + " samples, give 1 to " +
                       std::to_string(MOST_SAMPLES)};
    return check_sizes(settings);
}

} // namespace lobelia::host
