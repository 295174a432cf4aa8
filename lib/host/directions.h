#pragma once

#include <vector>

#include <lobelia/host/image.h>

#include "camera_rays.h"

namespace lobelia::host {

/// The unit vectors that the texel centres of an image show, in the order of its texels. A cube's
/// `width` is its face.
std::vector<Vector> texel_directions(Layout layout, std::uint32_t width, std::uint32_t height);

/// Solid angles in steradians of the texels of one face of a cube map, row by row.
std::vector<double> solid_angles(std::uint32_t size);

/// The cube map `cube`, averaged by solid angle over blocks of texels into faces of `size`, which
/// divides the face by a whole number.
Image reduced_cube(const Image& cube, std::uint32_t size);

} // namespace lobelia::host
