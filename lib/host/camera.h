#pragma once

#include <cstdint>
#include <vector>

#include <lobelia/exact.h>
#include <lobelia/sphere.h>

namespace lobelia::host {

/// A pixel that the sphere covers, at least partly, and what a method that integrates the
/// environment needs to know about it.
struct SpherePixel {
    std::uint32_t index; // y * width + x
    float normal[3];
    float mirror[3];
};

/// All pixels that the sphere may cover, row by row, with the normals and mirror directions that
/// the sphere pass uses there, computed in double precision.
std::vector<SpherePixel> sphere_pixels(const SphereView& view);

} // namespace lobelia::host
