#pragma once

#include <array>
#include <cstring>
#include <vector>

#include <lobelia/importance.h>
#include <lobelia/mips.h>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

/// The mips of a cube map, all levels.
inline host::GpuImage mips_of(host::Gpu& gpu, const host::GpuImage& cube,
                              VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT,
                              MipWeights weights = MipWeights::solid_angle) {
    const std::uint32_t size = cube.description().width;
    std::uint32_t levels = 1;
    while (size >> levels) ++levels;
    host::GpuImage image = value_of(
        gpu.create_image({.format = format,
                          .width = size,
                          .height = size,
                          .layers = 6,
                          .levels = levels,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                   VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                          .cube = true}));
    const Mips mips = value_of(Mips::create(gpu.device()));
    const MipsJob job = value_of(mips.bind(cube_of(cube), cube_of(image), weights));
    value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return image;
}

/// What Importance makes of a cube map about each axis. `split` says how many steps each submission
/// records; what is left goes into the last.
inline std::vector<std::array<float, 4>> sampled(host::Gpu& gpu, const host::GpuImage& source,
                                                 ImportanceSettings settings,
                                                 const std::vector<oracle::Direction>& axes,
                                                 const std::vector<std::uint32_t>& split = {}) {
    std::vector<std::array<float, 4>> values;
    for (const oracle::Direction& axis : axes)
        values.push_back({float(axis.x), float(axis.y), float(axis.z), 0});
    const std::size_t bytes = values.size() * sizeof values[0];
    const auto buffer = [&] {
        return value_of(
            gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::host));
    };
    const host::GpuBuffer directions = buffer(), results = buffer();
    std::memcpy(directions.data(), values.data(), bytes);
    std::memset(results.data(), 0xff, bytes); // NaN: nothing leans on what was there

    settings.query_count = std::uint32_t(axes.size());
    const Importance importance = value_of(Importance::create(gpu.device()));
    const ImportanceJob job =
        value_of(importance.bind(cube_of(source), settings, directions.handle(), results.handle()));
    std::uint32_t first = 0;
    const auto submit = [&](std::uint32_t count) {
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
        first += count;
    };
    for (std::uint32_t count : split)
        if (count <= job.steps() - first) submit(count);
    submit(job.steps() - first);
    std::memcpy(values.data(), results.data(), bytes);
    return values;
}

} // namespace lobelia::test
