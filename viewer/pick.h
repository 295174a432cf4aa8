#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <lobelia/sphere.h>

namespace lobelia::cli {

/// Directions at a point of the sphere, in the world.
struct SurfaceDirections {
    std::array<float, 3> normal{};
    std::array<float, 3> mirror{}; // where a mirror would show the environment
};

/// What a pixel's centre shows of the sphere; nothing where it shows the background.
std::optional<SurfaceDirections> surface_at(const SphereView& view, std::uint32_t x,
                                            std::uint32_t y);

/// A pixel that was asked about.
struct Pick {
    std::uint32_t x = 0, y = 0;
    SurfaceDirections directions;
    float exponent = 0.0f;
    std::array<float, 3> shown{}, exact{}; // linear radiance
};

/// The largest error of a channel relative to the exact value.
float relative_error(const Pick& pick);

} // namespace lobelia::cli
