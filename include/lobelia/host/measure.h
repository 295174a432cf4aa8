#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <lobelia/host/work.h>

namespace lobelia::host {

/// What work costs when it is warm: its pipelines compiled, its memory touched. Each time is the
/// median of several runs, unless there is no spread.
struct Cost {
    double cpu_ms = 0.0;          // process CPU time
    std::optional<double> gpu_ms; // device timestamps
    /// The longest run less the shortest, over the median; by cpu_ms on a CPU device or where there
    /// are no timestamps, else by gpu_ms. Absent where the work takes so long that it ran once.
    std::optional<double> spread;
    std::optional<std::uint64_t> fetches; // of texels, by methods that fix their number
    std::uint64_t bytes = 0;              // read and written, each texel once a pass
    std::uint64_t dispatches = 0;         // or draws
};

/// What a method found and what it cost.
struct Measured {
    std::vector<float> colours; // R G B of each direction or pixel
    Cost cost;
};

/// A method and what it is measured on, which outlives the call.
struct PrefilterCase {
    const GpuEnvironment* environment = nullptr;
    PrefilterSettings settings{};
};
struct ShadingCase {
    const GpuEnvironment* environment = nullptr;
    RenderSettings settings{};
};

/// Measures `settings.method` at `settings.exponents[0]`, its only one, of each case: P_n at
/// `directions` (unit vectors, at least one), for the chain as MapReader reads its map, and what it
/// costs to make the whole map. That has, whatever the method, the size that the chain's plan gives
/// it; `settings.width` and `height` are not read. Of maps by sampling or exact a part is timed
/// and scaled up. The cases are timed in turns, so that their times can be compared.
Outcome<std::vector<Measured>> measure_prefilter(Gpu& gpu, std::span<const PrefilterCase> cases,
                                                 std::span<const std::array<float, 3>> directions);

/// Measures `settings.method` of each case: the colours of the pixels that the sphere covers wholly
/// in `settings.view`, and what it costs to draw a picture of `timed_size` pixels a side from maps
/// that are there already. What takes long is timed in a smaller picture, the reference in
/// `settings.view`, and scaled up. The cases are timed in turns.
Outcome<std::vector<Measured>> measure_shading(Gpu& gpu, std::span<const ShadingCase> cases,
                                               std::uint32_t timed_size);

/// Measures the yardstick: a vkCmdBlitImage mip chain of a cube map with faces of `face` texels,
/// R32G32B32A32_SFLOAT.
Outcome<Cost> measure_mip_chain(Gpu& gpu, std::uint32_t face);

} // namespace lobelia::host
