#include "display_pipeline.h"

#include <iterator>

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr std::uint32_t VERTEX_SPIRV[] = {
#include "sphere.vert.inc"
};
constexpr std::uint32_t FRAGMENT_SPIRV[] = {
#include "display.frag.inc"
};

Outcome<OwnedShader> make_shader(VkDevice device, const std::uint32_t* words, std::size_t bytes) {
    const VkShaderModuleCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = bytes, .pCode = words};
    VkShaderModule handle = VK_NULL_HANDLE;
    const VkResult code = vkCreateShaderModule(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return vulkan_failure("create a shader", code);
    return OwnedShader(device, handle);
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, const OwnedShader& shader) {
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
            .stage = bit,
            .module = shader.get(),
            .pName = "main"};
}

} // namespace

Outcome<OwnedPipeline> make_display_pipeline(VkDevice device, VkRenderPass pass,
                                             VkPipelineLayout layout,
                                             const DisplayVariant& variant) {
    const auto vertex = make_shader(device, VERTEX_SPIRV, sizeof VERTEX_SPIRV);
    if (!vertex) return vertex.error();
    const auto fragment = make_shader(device, FRAGMENT_SPIRV, sizeof FRAGMENT_SPIRV);
    if (!fragment) return fragment.error();
    // The constants' order is that of the variant's members.
    VkSpecializationMapEntry entries[sizeof variant / sizeof(std::uint32_t)];
    for (std::uint32_t i = 0; i < std::size(entries); ++i)
        entries[i] = {i, i * std::uint32_t(sizeof(std::uint32_t)), sizeof(std::uint32_t)};
    const VkSpecializationInfo constants{std::uint32_t(std::size(entries)), entries, sizeof variant,
                                         &variant};
    VkPipelineShaderStageCreateInfo stages[] = {stage(VK_SHADER_STAGE_VERTEX_BIT, *vertex),
                                                stage(VK_SHADER_STAGE_FRAGMENT_BIT, *fragment)};
    stages[1].pSpecializationInfo = &constants;
    const VkPipelineVertexInputStateCreateInfo no_vertices{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo triangles{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo rasterization{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1.0f};
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineColorBlendAttachmentState written{
        .colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                          VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
    const VkPipelineColorBlendStateCreateInfo blending{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1,
        .pAttachments = &written};
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = states};
    const VkGraphicsPipelineCreateInfo info{.sType =
                                                VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                            .stageCount = 2,
                                            .pStages = stages,
                                            .pVertexInputState = &no_vertices,
                                            .pInputAssemblyState = &triangles,
                                            .pViewportState = &viewport,
                                            .pRasterizationState = &rasterization,
                                            .pMultisampleState = &samples,
                                            .pColorBlendState = &blending,
                                            .pDynamicState = &dynamic,
                                            .layout = layout,
                                            .renderPass = pass};
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult code =
        vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    if (code != VK_SUCCESS) return vulkan_failure("create the display's pipeline", code);
    return OwnedPipeline(device, pipeline);
}

} // namespace lobelia::cli
