#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lobelia {

using std::exp2;
using std::floor;
using std::log2;
using std::max;
using std::min;
using std::sqrt;
using uint = std::uint32_t;

#define SHARED inline
#include "lobelia/albedo.glsl" // phong_albedo()
#include "lobelia/ladder.glsl" // ladder_exponent(), ladder_place()
#include "lobelia/lobe.glsl"   // Lobe, LOBE_*, lobe_density(), lobe_sample_chord(), phong_brdf()
#undef SHARED

/// The cosine lobe of a perfectly diffuse surface.
inline Lobe lambert() {
    return {LOBE_LAMBERT, 0.0f};
}

/// Phong's specular lobe. `exponent` >= 0; larger is sharper.
inline Lobe phong(float exponent) {
    return {LOBE_PHONG, exponent};
}

} // namespace lobelia
