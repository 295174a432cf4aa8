#pragma once

#include <iterator>

#include <lobelia/sphere.h>

namespace lobelia::cli {

struct Preset {
    const char* name;
    Material material;
};

/// Materials to begin from; kd + ks <= 1 in each. Metals' ks are their linear colours.
inline constexpr Preset PRESETS[] = {
    {"default", {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 64.0f}},
    {"plaster", {{0.8f, 0.78f, 0.74f}, {0.0f, 0.0f, 0.0f}, 1.0f}},
    {"satin", {{0.12f, 0.2f, 0.42f}, {0.3f, 0.3f, 0.3f}, 12.0f}},
    {"red plastic", {{0.55f, 0.04f, 0.03f}, {0.06f, 0.06f, 0.06f}, 300.0f}},
    {"glazed clay", {{0.45f, 0.2f, 0.1f}, {0.2f, 0.2f, 0.2f}, 900.0f}},
    {"brushed steel", {{0.0f, 0.0f, 0.0f}, {0.56f, 0.57f, 0.58f}, 40.0f}},
    {"copper", {{0.0f, 0.0f, 0.0f}, {0.955f, 0.638f, 0.538f}, 150.0f}},
    {"gold", {{0.0f, 0.0f, 0.0f}, {1.0f, 0.78f, 0.34f}, 400.0f}},
    {"mirror", {{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}, 10000.0f}},
};
inline constexpr int PRESET_COUNT = int(std::size(PRESETS));

} // namespace lobelia::cli
