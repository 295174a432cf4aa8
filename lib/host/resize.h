#pragma once

#include <lobelia/host/image.h>

namespace lobelia::host {

/// A cube map with faces of `size` texels: each texel the mean over its area of the texels of
/// `cube` that it covers, in the face's plane, weighted by solid angle.
Image resize_faces(const Image& cube, std::uint32_t size);

} // namespace lobelia::host
