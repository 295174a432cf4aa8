#include "host/cube_layout.h"

#include <algorithm>

#include "host/sizes.h"

namespace lobelia::host {

namespace {

// Both layouts order the faces +X -X +Y -Y +Z -Z. Vulkan looks at them from inside, OpenEXR from
// outside, which mirrors the +Y and -Y faces top to bottom and the others left to right. Mirroring
// undoes itself, so one copy serves both ways; a picture of six faces from top to bottom has the
// same order in memory as six layers.
void mirror_faces(const Image& source, Image& target, std::uint32_t size) {
    const std::size_t row = std::size_t(size) * 4;
    for (std::uint32_t face = 0; face < FACES; ++face) {
        const bool upright = face != 2 && face != 3;
        for (std::uint32_t y = 0; y < size; ++y) {
            const std::uint32_t source_y = upright ? y : size - 1 - y;
            const float* from = source.texels.data() + (std::size_t(face) * size + source_y) * row;
            float* to = target.texels.data() + (std::size_t(face) * size + y) * row;
            if (!upright) {
                std::copy_n(from, row, to);
                continue;
            }
            for (std::uint32_t x = 0; x < size; ++x)
                std::copy_n(from + (size - 1 - x) * std::size_t(4), 4, to + x * std::size_t(4));
        }
    }
}

} // namespace

Image cube_from_exr_layout(const Image& file) {
    Image cube{Layout::cube, file.width, file.width, FACES, {}};
    cube.texels.resize(file.texels.size());
    mirror_faces(file, cube, file.width);
    return cube;
}

Image exr_layout_from_cube(const Image& cube) {
    Image file{Layout::cube, cube.width, cube.width * FACES, 1, {}};
    file.texels.resize(cube.texels.size());
    mirror_faces(cube, file, cube.width);
    return file;
}

} // namespace lobelia::host
