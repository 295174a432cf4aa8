#pragma once

#include <cmath>
#include <cstdint>

namespace lobelia {

using std::max;
using std::sqrt;
using uint = std::uint32_t;

#define SHARED inline
#include "lobelia/clipped_lobe.glsl" // clipped_table_point(), clipped_taps(), horizon_taps()
#undef SHARED

/// Moments of the specular lobe (w.R)^n (N.w) over the directions w in front of R and above the
/// horizon of N, as a density. By symmetry their mean lies in the plane of N and R.
///
/// With w = (cos e sin p, sin e, cos e cos p), p the angle from R towards N in that plane and e the
/// elevation from it, the lobe is cos^(n+1) e times a function of p: moments are products of
/// one-dimensional integrals, and the mean square of sin e is 1 / (n + 4) whatever the horizon
/// does.
struct ClippedMoments {
    double shift;    // angle of the mean from R towards N, radians
    double deficit;  // 1 - length of the mean
    double in_plane; // mean square of w along the direction of the plane that is square to the mean
    double across;   // mean square of w along N x R
    double tilt;     // mean product of w along the mean and along that direction
};

/// For `cosine` = N.R in [0, 1] and `exponent` in [0, 1e6], each to a relative 1e-8. Takes about 30
/// microseconds.
ClippedMoments clipped_moments(double cosine, double exponent);

/// Exponents and places of the taps whose moments are those of the clipped lobe.
struct MatchedTaps {
    double shift;            // of the axis from R towards N, radians
    double one_tap_exponent; // one lobe on the axis has the same mean, so linear light is exact
    double two_tap_exponent; // two lobes across it have the same mean, and
    double two_tap_angle;    // (radians, from the axis) the same across - in_plane
};
MatchedTaps matched_taps(double cosine, double exponent);

/// The pair of lobes that together with horizon_taps() has the moments that two taps have.
struct HorizonPair {
    double weight;   // of the horizon's taps; the pair's is 1 more
    double shift;    // as in MatchedTaps
    double exponent; // of each
    double angle;    // from the axis
};
HorizonPair horizon_pair(double cosine, double exponent);

} // namespace lobelia
