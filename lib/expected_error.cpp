#include <lobelia/expected_error.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <span>

namespace lobelia {

namespace {

#include "expected_error_table.inc"

constexpr double MARGIN = 2; // over the worst that was measured
constexpr double NOTHING = std::numeric_limits<double>::infinity();

// Of the cube maps that the table was made on.
double measured_size(Quality quality) {
    return quality == Quality::high ? 512 : 256;
}

/// The largest of the knots from the last one at or below `least` to the first at or above `most`:
/// errors rise and fall between knots as levels change.
double largest(std::span<const double> exponents, const double* errors, double least, double most) {
    auto first = std::upper_bound(exponents.begin(), exponents.end(), least);
    if (first != exponents.begin()) --first;
    const auto last = std::lower_bound(exponents.begin(), exponents.end(), most);
    if (last == exponents.end()) return NOTHING;
    return *std::max_element(errors + (first - exponents.begin()),
                             errors + (last - exponents.begin()) + 1);
}

/// How much larger the source's texels are than those of the table; smaller ones are taken for no
/// better.
double texel_ratio(Quality quality, std::uint32_t source_size) {
    return std::max(measured_size(quality) / double(source_size), 1.0);
}

/// Over larger texels a lobe errs as sharper ones do over those of the table, since its width
/// counts in texels; and suns, which stand in the middle of theirs, are off by so much more.
double error_at(std::span<const double> exponents, const double* errors, Quality quality,
                double least, double most, std::uint32_t source_size) {
    const double texel = texel_ratio(quality, source_size);
    return MARGIN * texel * largest(exponents, errors, least, most * texel * texel);
}

/// Row of the table.
std::optional<std::size_t> row_of(SphereMethod method) {
    switch (method) {
    case SphereMethod::one_tap: return 0;
    case SphereMethod::two_tap: return 1;
    case SphereMethod::hybrid: return 2;
    default: return std::nullopt;
    }
}

} // namespace

double expected_map_error(Quality quality, float exponent, std::uint32_t source_size) noexcept {
    return error_at(MAP_EXPONENTS, MAP_ERRORS[std::size_t(quality)], quality, double(exponent),
                    double(exponent), source_size);
}

double expected_lambert_error(Quality quality, std::uint32_t source_size) noexcept {
    return MARGIN * texel_ratio(quality, source_size) *
           MAP_ERRORS[std::size_t(quality)][std::size(MAP_EXPONENTS)];
}

double expected_diffuse_error(SphereMethod method, Quality quality,
                              std::uint32_t source_size) noexcept {
    if (method == SphereMethod::reference) return EXPECTED_REFERENCE_ERROR;
    if (method != SphereMethod::split_sum && !row_of(method)) return NOTHING;
    return MARGIN * texel_ratio(quality, source_size) * DIFFUSE_ERRORS[std::size_t(quality)];
}

double expected_specular_error(SphereMethod method, Quality quality, float least, float most,
                               std::uint32_t source_size) noexcept {
    if (method == SphereMethod::reference) return EXPECTED_REFERENCE_ERROR;
    const auto row = row_of(method);
    if (!row) return NOTHING;
    return error_at(SPHERE_EXPONENTS, SPECULAR_ERRORS[*row][std::size_t(quality)], quality,
                    double(least), double(most), source_size);
}

} // namespace lobelia
