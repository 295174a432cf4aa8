#include "host/tone_map.h"

#include <algorithm>
#include <cmath>

namespace lobelia::host {

// Khronos 2024, "PBR Neutral Tone Mapping" specification, with its names for the constants.
std::array<float, 3> tone_map_neutral(std::array<float, 3> colour) {
    constexpr float F90 = 0.04f; // reflectance of a common dielectric, taken out of the blacks
    constexpr float K_S = 0.8f - F90;
    constexpr float K_D = 0.15f;

    const float x = *std::min_element(colour.begin(), colour.end());
    const float offset = x <= 2.0f * F90 ? x - x * x / (4.0f * F90) : F90;
    for (float& c : colour) c -= offset;
    const float peak = *std::max_element(colour.begin(), colour.end());
    if (peak <= K_S) return colour;

    const float room = 1.0f - K_S;
    const float new_peak = 1.0f - room * room / (peak + room - K_S);
    const float grey = 1.0f - 1.0f / (K_D * (peak - new_peak) + 1.0f);
    for (float& c : colour) c = c * (new_peak / peak) * (1.0f - grey) + new_peak * grey;
    return colour;
}

float srgb_from_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

} // namespace lobelia::host
