#pragma once

#include <array>
#include <vector>

namespace lobelia {

/// One texel of a table that clipped_lobe.glsl reads: numbers from 0 to 1.2, so smooth that halves
/// lose nothing that matters.
using ClippedTexel = std::array<float, 4>;

/// CLIPPED_TABLE_HEIGHT rows of CLIPPED_TABLE_WIDTH texels, each what clipped_taps() takes. Takes
/// about 15 milliseconds.
std::vector<ClippedTexel> make_clipped_table();

/// The same for the horizon's pair: what clipped_taps() takes for shift, two taps and offset, with
/// the weight of the horizon's taps in second place.
std::vector<ClippedTexel> make_horizon_table();

} // namespace lobelia
