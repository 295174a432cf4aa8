#pragma once

#include <cstdint>

#include <lobelia/prefilter.h>
#include <lobelia/sphere_method.h>

namespace lobelia {

// The error to expect, pointwise relative: the root mean square of
// |x - exact| / (|exact| + 1e-3 mean), over directions or the pixels of a sphere. Twice the worst
// that was measured on hard environments, photographed and made; docs/accuracy.md has the command.
// Infinite where nothing is promised.
//
// `source_size` is the edge of the cube map that is filtered, made by PanoramaToCube. Nothing is
// promised of lobes beyond n = 10,000, or as sharp beside the source's texels as that is beside
// those of the default size.

/// Of Prefilter's map of that exponent, as MapReader reads it.
LOBELIA_API double expected_map_error(Quality quality, float exponent,
                                      std::uint32_t source_size) noexcept;
/// Of the map of the diffuse lobe.
LOBELIA_API double expected_lambert_error(Quality quality, std::uint32_t source_size) noexcept;

/// Of a sphere that shows one lobe alone; exponents from `least` to `most`, the largest among them.
/// kurt2019, importance and plain_split_sum promise nothing, nor do sh2 and sh4, which ring around
/// suns, nor split_sum of its specular lobe, which shows suns below the horizon.
LOBELIA_API double expected_diffuse_error(SphereMethod method, Quality quality,
                                          std::uint32_t source_size) noexcept;
LOBELIA_API double expected_specular_error(SphereMethod method, Quality quality, float least,
                                           float most, std::uint32_t source_size) noexcept;

/// What Exact is off by, against sums in double precision, and what SphereMethod::reference is.
constexpr double EXPECTED_EXACT_ERROR = 1e-5;
constexpr double EXPECTED_REFERENCE_ERROR = 1e-4;

} // namespace lobelia
