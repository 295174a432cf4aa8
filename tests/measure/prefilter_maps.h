#pragma once

#include <span>
#include <string>
#include <vector>

#include <lobelia/exact.h>
#include <lobelia/map_reader.h>
#include <lobelia/panorama.h>
#include <lobelia/prefilter.h>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

using Directions = std::vector<oracle::Direction>;

/// A panorama on the device with its cube map.
struct Environment {
    host::GpuImage panorama;
    host::GpuImage cube;
    Panorama lent;
    oracle::Rgb mean; // over the sphere
};
Environment load(host::Gpu& gpu, const host::Image& panorama, std::uint32_t face);

/// The maps of a plan with what they need.
struct Maps {
    PrefilterPlan plan;
    std::vector<host::GpuImage> images;
    host::GpuBuffer scratch, state;
    PrefilterJob job;
};
Maps bind_maps(host::Gpu& gpu, const Prefilter& prefilter, const host::GpuImage& cube,
               std::span<const float> exponents, bool lambert, Quality quality,
               VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT);

/// P_n at each direction, R G B one after the other: integrated, and as a shader reads map number
/// `index`.
std::vector<double> truth(host::Gpu& gpu, const Exact& exact, const Panorama& panorama,
                          float exponent, const Directions& directions);
std::vector<double> read(host::Gpu& gpu, const MapReader& reader, const Maps& maps,
                         std::size_t index, const Directions& directions);

host::GpuImage cube_image(host::Gpu& gpu, VkFormat format, std::uint32_t face,
                          std::uint32_t levels = 1);

} // namespace lobelia::test
