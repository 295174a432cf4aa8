#pragma once

#include <cstdint>

#include <vulkan/vulkan_core.h>

namespace lobelia {

/// A latitude-longitude panorama, lent: level 0, layer 0 of an image of any float format that can
/// be sampled, linear radiance. Texel (x, y) is constant radiance over its own solid angle; the
/// image centre is +Z, the top +Y, u = 0.25 is +X (README, "Conventions"). The library makes its
/// own views.
struct Panorama {
    VkImage image = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::uint32_t width = 0;  // texels
    std::uint32_t height = 0; // texels
};

/// A cube map, lent: a cube-compatible image with six layers in Vulkan's order and orientation. The
/// library makes its own views.
struct CubeMap {
    VkImage image = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::uint32_t size = 0; // edge of a face at level 0, texels
    std::uint32_t levels = 1;
};

} // namespace lobelia
