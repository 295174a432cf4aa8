#pragma once

#include <array>
#include <cmath>
#include <cstring>

#include <lobelia/exact.h>

#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"

namespace lobelia::test {

/// Asks the exact integration for averages and hands them back.
class ExactTest : public GpuTest {
protected:
    using Average = std::array<float, 4>; // R G B and the integral of the weight
    using Directions = std::vector<oracle::Direction>;

    Exact exact = value_of(Exact::create(gpu.device()));

    static ExactQuery query(oracle::Direction axis, oracle::Direction normal) {
        return {{float(axis.x), float(axis.y), float(axis.z)},
                0,
                {float(normal.x), float(normal.y), float(normal.z)},
                0};
    }
    static std::vector<ExactQuery> unclipped(const Directions& axes) {
        std::vector<ExactQuery> queries;
        for (oracle::Direction axis : axes) queries.push_back(query(axis, axis));
        return queries;
    }

    /// `split` says how many steps each submission records; what is left goes into the last.
    std::vector<Average> ask(const host::GpuImage& source, ExactSettings settings,
                             const std::vector<ExactQuery>& queries,
                             const std::vector<std::uint32_t>& split = {}) {
        return source.description().cube
                   ? ask_source(cube_of(source), settings, queries, split)
                   : ask_source(panorama_of(source), settings, queries, split);
    }
    std::vector<Average> averages(const host::GpuImage& source, float exponent,
                                  const Directions& axes) {
        return ask(source, {.exponent = exponent}, unclipped(axes));
    }
    std::vector<Average> averages(const oracle::Source& source, float exponent,
                                  const Directions& axes) {
        return averages(on_device(gpu, image_of(source)), exponent, axes);
    }

    /// What the last question was split into.
    std::uint32_t steps = 0;

private:
    template <class Source>
    std::vector<Average> ask_source(const Source& source, ExactSettings settings,
                                    const std::vector<ExactQuery>& queries,
                                    const std::vector<std::uint32_t>& split) {
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
        steps = job.steps();
        std::uint32_t first = 0;
        const auto submit = [&](std::uint32_t count) {
            value_of(
                gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
            first += count;
        };
        for (std::uint32_t count : split)
            if (count <= steps - first) submit(count);
        submit(steps - first);

        std::vector<Average> averages(queries.size());
        std::memcpy(averages.data(), results.data(), sizes.results);
        return averages;
    }
};

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
