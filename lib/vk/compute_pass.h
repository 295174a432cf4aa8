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
    const char* name;
    Interface interface;
    Pipeline pipeline;
};
ComputePass make_compute_pass(const Context& context, const ComputePassDescription& description);

/// Binds the pipeline, one descriptor set and the push constants of a pass.
template <class Params>
void begin_pass(const Context& context, VkCommandBuffer commands, const ComputePass& pass,
                VkDescriptorSet set, const Params& params) {
    const VkPipelineLayout layout = pass.interface.layout.get();
    context.call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pass.pipeline.get());
    context.call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1,
                                         &set, 0, nullptr);
    context.call.vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof params,
                                    &params);
}

/// The workgroups of a dispatch. A piece of it is one row of them, or one group where there is one
/// row.
struct Groups {
    std::uint32_t x, y, z;

    std::uint32_t pieces() const { return y * z > 1 ? y * z : x; }
};
/// Dispatches pieces [first, first + count) of the bound pass.
void dispatch_pieces(const Context& context, VkCommandBuffer commands, const Groups& groups,
                     std::uint32_t first, std::uint32_t count);

/// The stages that may read what a pass writes, or write it anew. A queue without graphics refuses
/// the name of fragment shaders, so nothing is named.
constexpr VkPipelineStageFlags ANY_STAGE = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;

/// How one image is used: the stage, its access, and the layout that goes with them.
struct ImageUse {
    VkPipelineStageFlags stage;
    VkAccessFlags access;
    VkImageLayout layout;
};
constexpr ImageUse DISCARDED{ANY_STAGE, VK_ACCESS_MEMORY_WRITE_BIT,
                             VK_IMAGE_LAYOUT_UNDEFINED}; // whatever it was before
constexpr ImageUse STORED{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                          VK_IMAGE_LAYOUT_GENERAL};
constexpr ImageUse SAMPLED{ANY_STAGE, VK_ACCESS_SHADER_READ_BIT,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// Moves all layers of `levels` levels of a colour image, `first_level` on, from one use to the
/// next.
void image_barrier(const Context& context, VkCommandBuffer commands, VkImage image,
                   const ImageUse& from, const ImageUse& to, std::uint32_t first_level = 0,
                   std::uint32_t levels = VK_REMAINING_MIP_LEVELS);

/// A view of all layers of one level: a cube map's faces as a 2D array for image stores, say.
ImageView make_level_view(const Context& context, VkImage image, VkFormat format,
                          VkImageViewType type, std::uint32_t level = 0);

/// A view of `layers` layers of level 0 as a 2D array.
ImageView make_layers_view(const Context& context, VkImage image, VkFormat format,
                           std::uint32_t first_layer, std::uint32_t layers);

/// A view of the first `levels` levels of a cube map, to be sampled by direction.
ImageView make_cube_view(const Context& context, VkImage image, VkFormat format,
                         std::uint32_t levels);

/// Makes what was written at `from` visible to `to` for the commands that follow.
void memory_barrier(const Context& context, VkCommandBuffer commands,
                    VkPipelineStageFlags from_stage, VkAccessFlags from,
                    VkPipelineStageFlags to_stage, VkAccessFlags to);

} // namespace lobelia::vk
