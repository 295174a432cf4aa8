#pragma once

#include <array>
#include <vector>

#include <lobelia/prefilter.h>

#include "prefilter_plan.h"
#include "vk/compute_pass.h"

namespace lobelia {

// Push constants, as in the shaders.
struct StatisticsParams {
    std::uint32_t size;
};
struct SunsParams {
    std::uint32_t size;
    float ladder_lowest;
};
struct PrepareParams {
    std::uint32_t size, margin, block;
};
struct MarginsParams {
    std::uint32_t size, margin;
};
struct HalveParams {
    std::uint32_t size, margin, source_margin;
};
struct BlurParams {
    std::uint32_t source_size, source_margin, size, margin, across;
    float sharpness, quadratic, last_chord, narrowing, drift, edge;
};
struct ProjectParams {
    std::uint32_t size, margin;
};
struct SumParams {
    std::uint32_t chunks;
};
struct ExpandParams {
    std::uint32_t size_across, degree;
    float reading;
    std::array<float, DEGREES> eigenvalues;
};

/// Which of the pipelines of its kind a pass runs.
std::size_t variant_of(const PlannedPass& planned, bool float_maps);

struct Prefilter::State {
    vk::Context context;
    vk::Sampler sampler;
    // By kind, and of those with several by variant_of().
    std::array<std::vector<vk::ComputePass>, PASS_KINDS> passes;

    const vk::ComputePass& pipeline(const PlannedPass& planned, bool float_maps) const {
        return passes[std::size_t(planned.kind)][variant_of(planned, float_maps)];
    }
};

/// The types of a pass's bindings, in their order.
std::span<const VkDescriptorType> prefilter_bindings(PlannedPass::Kind kind);

} // namespace lobelia
