#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lobelia::host {

/// How the texels of an image cover the sphere of directions (README, "Conventions").
enum class Layout {
    latlong, // one layer, width x height over longitude and latitude
    cube,    // six square layers in Vulkan's order +X -X +Y -Y +Z -Z and orientation
};

/// Linear radiance or any float image in memory: `layers` images of `height` rows of `width` texels
/// of four floats R G B A, row 0 at the top. An environment's alpha means nothing and is 1.
struct Image {
    Layout layout = Layout::latlong;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t layers = 1;
    std::vector<float> texels; // layers * height * width * 4

    float* texel(std::uint32_t layer, std::uint32_t x, std::uint32_t y) {
        return texels.data() + ((std::size_t(layer) * height + y) * width + x) * 4;
    }
    const float* texel(std::uint32_t layer, std::uint32_t x, std::uint32_t y) const {
        return texels.data() + ((std::size_t(layer) * height + y) * width + x) * 4;
    }
};

} // namespace lobelia::host
