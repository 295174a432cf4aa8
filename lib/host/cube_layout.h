#pragma once

#include <lobelia/host/image.h>

namespace lobelia::host {

/// The cube map that a picture of OpenEXR's cube layout holds (ImfEnvmap.h: six faces from top to
/// bottom, each seen from outside). `file` is one layer, six times as high as wide.
Image cube_from_exr_layout(const Image& file);

/// The inverse: one layer with the six faces of `cube` from top to bottom.
Image exr_layout_from_cube(const Image& cube);

} // namespace lobelia::host
