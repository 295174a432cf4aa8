#pragma once

#include <span>

#include "vk/objects.h"

namespace lobelia::vk {

/// What a pass that draws one triangle over the viewport is, as data. Binding `i` of set 0 has type
/// `bindings[i]`; specialisation constant `i` of the fragment shader has the value `constants[i]`.
/// It writes all of colour attachment 0; a null `render_pass` means dynamic rendering in `format`.
struct FullScreenPassDescription {
    const char* name;
    std::span<const std::uint32_t> vertex_spirv;
    std::span<const std::uint32_t> fragment_spirv;
    std::span<const VkDescriptorType> bindings;
    std::uint32_t push_constant_size; // bytes, for both stages
    std::span<const std::uint32_t> constants;
    VkRenderPass render_pass;
    std::uint32_t subpass;
    VkFormat format;
};

struct FullScreenPass {
    Interface interface;
    Pipeline pipeline;
};
FullScreenPass make_full_screen_pass(const Context& context,
                                     const FullScreenPassDescription& description);

/// Draws with one descriptor set into the upper left width x height pixels.
template <class Params>
void draw_full_screen(const Context& context, VkCommandBuffer commands, const FullScreenPass& pass,
                      VkDescriptorSet set, const Params& params, std::uint32_t width,
                      std::uint32_t height, const VkRect2D& part) {
    const VkPipelineLayout layout = pass.interface.layout.get();
    const VkViewport viewport{0, 0, float(width), float(height), 0, 1};
    context.call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass.pipeline.get());
    context.call.vkCmdSetViewport(commands, 0, 1, &viewport);
    context.call.vkCmdSetScissor(commands, 0, 1, &part);
    context.call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1,
                                         &set, 0, nullptr);
    context.call.vkCmdPushConstants(commands, layout,
                                    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                    sizeof params, &params);
    context.call.vkCmdDraw(commands, 3, 1, 0, 0);
}

} // namespace lobelia::vk
