#pragma once

#include <array>

namespace lobelia::host {

/// Khronos PBR Neutral: linear Rec. 709 radiance, each channel >= 0 and finite, to [0, 1].
std::array<float, 3> tone_map_neutral(std::array<float, 3> colour);

/// The sRGB code value in [0, 1] of a linear value in [0, 1] (IEC 61966-2-1).
float srgb_from_linear(float linear);

} // namespace lobelia::host
