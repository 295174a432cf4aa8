#pragma once

#include <array>

#include <lobelia/prefilter.h>

#include "prefilter_plan.h"
#include "vk/compute_pass.h"

namespace lobelia {

// Push constants, as in the shaders.
struct StatisticsParams {
    std::uint32_t size;
};
struct PrepareParams {
    std::uint32_t size, margin, block;
};
struct HalveParams {
    std::uint32_t size, margin, source_margin;
};
struct BlurParams {
    std::uint32_t source_size, source_margin, size, margin;
    float sharpness, quadratic, last_chord, narrowing;
};
struct ProjectParams {
    std::uint32_t size, margin;
};
struct SumParams {
    std::uint32_t chunks;
};
struct ExpandParams {
    std::uint32_t size;
    std::array<float, DEGREES> eigenvalues;
};
struct BroadParams {
    std::array<float, BROAD_MAPS> exponents;
    std::uint32_t source_size, size;
    float narrowing;
};

struct Prefilter::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass statistics, suns, prepare, halve, blur_level, blur_map, project, sum, expand;
    vk::ComputePass broad[BROAD_MAPS]; // by the number of maps less one

    const vk::ComputePass& pipeline(const PlannedPass& planned) const;
};

/// The types of a pass's bindings, in their order.
std::span<const VkDescriptorType> prefilter_bindings(PlannedPass::Kind kind);

} // namespace lobelia
