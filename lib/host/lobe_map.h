#pragma once

#include <lobelia/host/image.h>

namespace lobelia::host {

/// The smallest face, a power of two from 16 up to `largest`, that has two texels for each standard
/// deviation 1 / sqrt(n) of the lobe, which is what linear filtering needs to be within 0.3 %.
std::uint32_t lobe_face(float exponent, std::uint32_t largest);

/// P_n of the cube map `cube` at the texel centres of a cube of `face`, summed on the CPU with four
/// texels for each standard deviation, or as many as the cube has.
Image lobe_map(const Image& cube, float exponent, std::uint32_t face);

} // namespace lobelia::host
