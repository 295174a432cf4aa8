#pragma once

#include <optional>

#include <lobelia/cube_to_cube.h>
#include <lobelia/host/gpu.h>
#include <lobelia/panorama.h>

namespace lobelia::host {

/// Of panoramas and cube maps that environments are.
constexpr VkImageUsageFlags ENVIRONMENT_USAGE =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
    VK_IMAGE_USAGE_TRANSFER_DST_BIT;

/// A cube map with what makes it of a panorama.
struct Resampling {
    GpuImage cube;
    PanoramaToCubeJob job;

    static Outcome<Resampling> create(Gpu& gpu, const GpuImage& panorama, std::uint32_t face);
};

/// A cube map in a size that prefilters read, with what makes it of one in another.
struct Resizing {
    GpuImage cube;
    CubeToCubeJob job;

    /// Nothing where `source` has such a size.
    static Outcome<std::optional<Resizing>> create(Gpu& gpu, const GpuImage& source);
};

} // namespace lobelia::host
