#pragma once

#include <span>

#include "vk/objects.h"

namespace lobelia::vk {

/// What a compute pass is, as data. Binding `i` of set 0 has type `bindings[i]`; specialisation
/// constant `i` has the value `constants[i]`.
struct ComputePassDescription {
    const char* name;
    std::span<const std::uint32_t> spirv;
    std::span<const VkDescriptorType> bindings;
    std::uint32_t push_constant_size; // bytes
    std::span<const std::uint32_t> constants = {};
};

struct ComputePass {
    Interface interface;
    Pipeline pipeline;
};
Result<ComputePass> make_compute_pass(const Context& context,
                                      const ComputePassDescription& description);

/// Makes what was written at `from` visible to `to` for the commands that follow.
void memory_barrier(const Context& context, VkCommandBuffer commands, VkPipelineStageFlags from_stage,
                    VkAccessFlags from, VkPipelineStageFlags to_stage, VkAccessFlags to);

} // namespace lobelia::vk
