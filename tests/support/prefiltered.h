#pragma once

#include <cstring>
#include <vector>

#include <lobelia/prefilter.h>

#include "support/gpu_sources.h"
#include "support/shared.h"

namespace lobelia {

#define SHARED inline
#include "lobelia/suns.glsl"
#undef SHARED

namespace test {

/// Maps on the device, with what belongs to them.
struct Prefiltered {
    PrefilterPlan plan;
    std::vector<host::GpuImage> maps;
    host::GpuBuffer state;

    const PrefilterState& found() const {
        return *reinterpret_cast<const PrefilterState*>(state.data());
    }
};

/// What is asked for; a PrefilterRequest that owns its list.
struct Wanted {
    std::vector<float> exponents;
    bool lambert = false;
    Quality quality = Quality::normal;
    VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
};

inline PrefilterPlan plan_for(const Wanted& wanted, std::uint32_t source_size) {
    return value_of(PrefilterPlan::make({.exponents = wanted.exponents,
                                         .lambert = wanted.lambert,
                                         .quality = wanted.quality,
                                         .map_format = wanted.format,
                                         .source_size = source_size}));
}

inline std::vector<host::GpuImage> images_for(host::Gpu& gpu, const PrefilterPlan& plan,
                                              VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT) {
    std::vector<host::GpuImage> images;
    for (const PrefilteredMap& map : plan.maps())
        images.push_back(value_of(
            gpu.create_image({.format = format,
                              .width = map.size,
                              .height = map.size,
                              .layers = 6,
                              .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                              .cube = true})));
    return images;
}

/// A storage buffer full of NaN, so that nothing leans on what was there.
inline host::GpuBuffer storage(host::Gpu& gpu, VkDeviceSize bytes, VkBufferUsageFlags more = 0) {
    host::GpuBuffer buffer = value_of(
        gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | more, host::Memory::host));
    std::memset(buffer.data(), 0xff, bytes);
    return buffer;
}

/// `split` says how many passes each submission records; what is left goes into the last.
inline Prefiltered make_maps(host::Gpu& gpu, const Prefilter& prefilter,
                             const host::GpuImage& source, const Wanted& wanted,
                             const std::vector<std::uint32_t>& split = {}) {
    PrefilterPlan plan = plan_for(wanted, source.description().width);
    Prefiltered made{plan, images_for(gpu, plan, wanted.format),
                     storage(gpu, plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)};
    std::vector<CubeMap> targets;
    for (const host::GpuImage& map : made.maps) targets.push_back(cube_of(map));
    const host::GpuBuffer scratch =
        storage(gpu, plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const PrefilterJob job = value_of(
        prefilter.bind(plan, cube_of(source), targets, scratch.handle(), made.state.handle()));

    std::uint32_t first = 0;
    const auto submit = [&](std::uint32_t count) {
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
        first += count;
    };
    for (std::uint32_t count : split)
        if (count <= plan.pass_count() - first) submit(count);
    submit(plan.pass_count() - first);
    return made;
}

/// An even cube map.
inline host::Image even_cube(std::uint32_t size, float red, float green, float blue) {
    host::Image image = even_panorama(size, 6 * size, red, green, blue);
    return {host::Layout::cube, size, size, 6, std::move(image.texels)};
}

/// The middles of a cube map's texels, in the order of its texels.
inline std::vector<oracle::Direction> texel_directions(int size) {
    std::vector<oracle::Direction> directions;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                directions.push_back(oracle::cube_direction(face, x + 0.5, y + 0.5, size));
    return directions;
}

} // namespace test
} // namespace lobelia
