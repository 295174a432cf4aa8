#pragma once

#include <cstdint>
#include <limits>

#include <lobelia/prefilter.h>

namespace lobelia {

constexpr double NONE = std::numeric_limits<double>::infinity();
constexpr std::uint32_t LEAST_MAP_SIZE = 32;

/// What tells the tiers apart; docs/prefilter.md has what they reach.
struct Tier {
    double texels_per_sigma;        // of a map
    double ladder_texels_per_sigma; // of the ladder's lowest rung, and half of that of its highest
    double cut;                     // end of a kernel in standard deviations
    double sharp_cut;               // the same for maps of SHARP_EXPONENT on, which cost most
    double series_end;              // what harmonics leave out
    double coarse_exponent;         // the largest whose map may have LEAST_MAP_SIZE
    std::uint32_t fine_size;        // the least of the others
};
const Tier& tier_of(Quality quality);

/// The sharpest exponent whose lobes a face of `size` texels holds that many to a standard
/// deviation.
double sharpest_for(double size, double texels_per_sigma);

/// A size of at least `needed` and `least` texels in whole steps, but no more than `largest`.
std::uint32_t in_steps(double needed, std::uint32_t least, std::uint32_t largest);

/// Texels that a map of a lobe needs.
std::uint32_t size_for(double exponent, const Tier& tier, std::uint32_t largest);

/// What a variance in the face's plane, at so many squared texels, is in its coordinates.
double texel_variance(std::uint32_t size, double texels_squared);

/// Mean over the sphere of what a variance in the face's plane is in radians squared per axis: for
/// kernels so wide that they see all of it.
double mean_on_sphere(double face_variance);

/// How many degrees of the series a lobe needs: what is left out is below `tolerance` of what a
/// single direction's light gives the series, in the norm over the sphere.
std::uint32_t degrees_for(double exponent, double tolerance);

} // namespace lobelia
