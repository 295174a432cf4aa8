#pragma once

#include <array>
#include <cstring>
#include <vector>

#include <lobelia/exact.h>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

using Average = std::array<float, 4>; // R G B, and what the method says in A

inline ExactQuery query(oracle::Direction axis, oracle::Direction normal) {
    return {{float(axis.x), float(axis.y), float(axis.z)},
            0,
            {float(normal.x), float(normal.y), float(normal.z)},
            0};
}
inline std::vector<ExactQuery> unclipped(const std::vector<oracle::Direction>& axes) {
    std::vector<ExactQuery> queries;
    for (oracle::Direction axis : axes) queries.push_back(query(axis, axis));
    return queries;
}

/// Averages, and how many steps they were split into.
struct Asked {
    std::vector<Average> averages; // R G B and the integral of the weight
    std::uint32_t steps = 0;
};

/// What Exact makes of a lent panorama or cube map. `split` says how many steps each submission
/// records; what is left goes into the last.
template <class Source>
Asked ask_source(host::Gpu& gpu, const Exact& exact, const Source& source, ExactSettings settings,
                 const std::vector<ExactQuery>& queries, const std::vector<std::uint32_t>& split) {
    settings.query_count = std::uint32_t(queries.size());
    const Exact::Sizes sizes = value_of(Exact::sizes(source, settings));
    const auto storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const host::GpuBuffer query_buffer =
        value_of(gpu.create_buffer(sizes.queries, storage, host::Memory::host));
    const host::GpuBuffer results =
        value_of(gpu.create_buffer(sizes.results, storage, host::Memory::host));
    const host::GpuBuffer tables = value_of(gpu.create_buffer(
        sizes.tables, storage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, host::Memory::device));
    std::memcpy(query_buffer.data(), queries.data(), sizes.queries);
    std::memset(results.data(), 0xff, sizes.results); // NaN: nothing leans on what was there

    const ExactJob job = value_of(
        exact.bind(source, settings, query_buffer.handle(), results.handle(), tables.handle()));
    Asked asked{std::vector<Average>(queries.size()), job.steps()};
    std::uint32_t first = 0;
    const auto submit = [&](std::uint32_t count) {
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
        first += count;
    };
    for (std::uint32_t count : split)
        if (count <= asked.steps - first) submit(count);
    submit(asked.steps - first);
    std::memcpy(asked.averages.data(), results.data(), sizes.results);
    return asked;
}

inline Asked ask(host::Gpu& gpu, const Exact& exact, const host::GpuImage& source,
                 const ExactSettings& settings, const std::vector<ExactQuery>& queries,
                 const std::vector<std::uint32_t>& split = {}) {
    return source.description().cube
               ? ask_source(gpu, exact, cube_of(source), settings, queries, split)
               : ask_source(gpu, exact, panorama_of(source), settings, queries, split);
}

inline oracle::Rgb largest(const oracle::Source& source) {
    oracle::Rgb most{};
    for (const oracle::Rgb& texel : source.texels())
        for (std::size_t c = 0; c < 3; ++c) most[c] = std::max(most[c], texel[c]);
    return most;
}

inline std::string shape_of(const oracle::Source& source) {
    return (source.is_cube() ? "cube " : "panorama ") + std::to_string(source.width()) + " x " +
           std::to_string(source.height());
}

} // namespace lobelia::test
