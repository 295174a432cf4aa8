#include "vk/full_screen_pass.h"

namespace lobelia::vk {

FullScreenPass make_full_screen_pass(const Context& context,
                                     const FullScreenPassDescription& description) {
    Interface interface = make_interface(context, description.name,
                                         VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                                         description.bindings, description.push_constant_size);
    const ShaderModule vertex = make_shader_module(context, description.vertex_spirv);
    const ShaderModule fragment = make_shader_module(context, description.fragment_spirv);

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < description.constants.size(); ++i)
        entries.push_back({i, i * 4, 4});
    const VkSpecializationInfo constants{std::uint32_t(entries.size()), entries.data(),
                                         description.constants.size_bytes(),
                                         description.constants.data()};
    const VkPipelineShaderStageCreateInfo stages[] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex.get(),
         .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment.get(),
         .pName = "main",
         .pSpecializationInfo = &constants}};
    const VkPipelineVertexInputStateCreateInfo vertices{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo rasterisation{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .cullMode = VK_CULL_MODE_NONE,
        .lineWidth = 1.0f};
    const VkPipelineMultisampleStateCreateInfo multisampling{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineColorBlendAttachmentState attachment{
        .colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                          VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
    const VkPipelineColorBlendStateCreateInfo blending{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1,
        .pAttachments = &attachment};
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = dynamic_states};
    const VkPipelineRenderingCreateInfo rendering{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1,
        .pColorAttachmentFormats = &description.format};
    const VkGraphicsPipelineCreateInfo info{.sType =
                                                VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                            .pNext = description.render_pass ? nullptr : &rendering,
                                            .stageCount = 2,
                                            .pStages = stages,
                                            .pVertexInputState = &vertices,
                                            .pInputAssemblyState = &assembly,
                                            .pViewportState = &viewport,
                                            .pRasterizationState = &rasterisation,
                                            .pMultisampleState = &multisampling,
                                            .pColorBlendState = &blending,
                                            .pDynamicState = &dynamic,
                                            .layout = interface.layout.get(),
                                            .renderPass = description.render_pass,
                                            .subpass = description.subpass};
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(context.call.vkCreateGraphicsPipelines(context.device.handle,
                                                 context.device.pipeline_cache, 1, &info,
                                                 context.device.allocator, &pipeline),
          "create graphics pipeline");
    set_name(context, VK_OBJECT_TYPE_PIPELINE, pipeline, description.name);
    return {std::move(interface), Pipeline(context, pipeline)};
}

} // namespace lobelia::vk
