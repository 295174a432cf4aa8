#pragma once

#include "support/source.h"

namespace lobelia::oracle {

/// A panorama averaged over the solid angle of texel (x, y) of a cube's face, `size` texels a side.
/// Exact along the texel's rows, which are cut where they cross the panorama's grid; the midpoint
/// rule over `lines` of them.
Rgb average_over_cube_texel(const Source& panorama, int face, int x, int y, int size, int lines);

} // namespace lobelia::oracle
