#include "pipeline.h"

#include <cstddef>

#include "shapes.h"

namespace {

constexpr std::uint32_t MESH_VERTEX_WORDS[] = {
#include "mesh.vert.inc"
};
constexpr std::uint32_t MESH_FRAGMENT_WORDS[] = {
#include "mesh.frag.inc"
};
constexpr std::uint32_t BACKGROUND_VERTEX_WORDS[] = {
#include "background.vert.inc"
};
constexpr std::uint32_t BACKGROUND_FRAGMENT_WORDS[] = {
#include "background.frag.inc"
};

constexpr VkShaderStageFlags BOTH = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

VkDescriptorType type_of(const Resource& resource) {
    return resource.view ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                         : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
}

void make_set(const Engine& engine, const std::vector<Resource>& resources, Pipeline& pipeline) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    std::vector<VkDescriptorPoolSize> sizes;
    for (const Resource& resource : resources) {
        bindings.push_back({std::uint32_t(bindings.size()), type_of(resource), 1,
                            VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
        sizes.push_back({type_of(resource), 1});
    }
    const VkDescriptorSetLayoutCreateInfo layout{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = std::uint32_t(bindings.size()),
        .pBindings = bindings.data()};
    check(vkCreateDescriptorSetLayout(engine.device, &layout, nullptr, &pipeline.set_layout),
          "create a set's layout");
    const VkDescriptorPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = 1,
                                          .poolSizeCount = std::uint32_t(sizes.size()),
                                          .pPoolSizes = sizes.data()};
    check(vkCreateDescriptorPool(engine.device, &pool, nullptr, &pipeline.pool), "create a pool");
    const VkDescriptorSetAllocateInfo set{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                          .descriptorPool = pipeline.pool,
                                          .descriptorSetCount = 1,
                                          .pSetLayouts = &pipeline.set_layout};
    check(vkAllocateDescriptorSets(engine.device, &set, &pipeline.set), "allocate a set");

    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        const Resource& resource = resources[i];
        const VkSamplerCreateInfo linear{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                         .magFilter = VK_FILTER_LINEAR,
                                         .minFilter = VK_FILTER_LINEAR,
                                         .addressModeU = resource.addressing,
                                         .addressModeV = resource.addressing,
                                         .addressModeW = resource.addressing};
        VkSampler sampler = VK_NULL_HANDLE;
        if (resource.view) {
            check(vkCreateSampler(engine.device, &linear, nullptr, &sampler), "create a sampler");
            pipeline.samplers.push_back(sampler);
        }
        const VkDescriptorImageInfo image{sampler, resource.view,
                                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        const VkDescriptorBufferInfo buffer{resource.buffer, 0, VK_WHOLE_SIZE};
        const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                         .dstSet = pipeline.set,
                                         .dstBinding = i,
                                         .descriptorCount = 1,
                                         .descriptorType = type_of(resource),
                                         .pImageInfo = &image,
                                         .pBufferInfo = &buffer};
        vkUpdateDescriptorSets(engine.device, 1, &write, 0, nullptr);
    }
}

VkShaderModule make_module(const Engine& engine, std::span<const std::uint32_t> words) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = words.size_bytes(),
                                        .pCode = words.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    check(vkCreateShaderModule(engine.device, &info, nullptr, &module), "create a shader");
    return module;
}

} // namespace

const std::span<const std::uint32_t> MESH_VERTEX = MESH_VERTEX_WORDS;
const std::span<const std::uint32_t> MESH_FRAGMENT = MESH_FRAGMENT_WORDS;
const std::span<const std::uint32_t> BACKGROUND_VERTEX = BACKGROUND_VERTEX_WORDS;
const std::span<const std::uint32_t> BACKGROUND_FRAGMENT = BACKGROUND_FRAGMENT_WORDS;

Pipeline Pipeline::create(const Engine& engine, const Description& description) {
    Pipeline pipeline{};
    make_set(engine, description.resources, pipeline);
    pipeline.push_constants = description.push_constants;
    const VkPushConstantRange range{BOTH, 0, description.push_constants};
    const VkPipelineLayoutCreateInfo layout{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                            .setLayoutCount = 1,
                                            .pSetLayouts = &pipeline.set_layout,
                                            .pushConstantRangeCount = 1,
                                            .pPushConstantRanges = &range};
    check(vkCreatePipelineLayout(engine.device, &layout, nullptr, &pipeline.layout),
          "create a pipeline's layout");

    const VkShaderModule vertex = make_module(engine, description.vertex);
    const VkShaderModule fragment = make_module(engine, description.fragment);
    const VkSpecializationMapEntry entry{0, 0, 4};
    const VkSpecializationInfo constants{1, &entry, 4, &description.constant};
    const VkPipelineShaderStageCreateInfo stages[] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex,
         .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = fragment,
         .pName = "main",
         .pSpecializationInfo = &constants}};
    const VkVertexInputBindingDescription binding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription attributes[] = {
        {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
        {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
        {2, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, tangent)},
        {3, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, place)}};
    const VkPipelineVertexInputStateCreateInfo input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
        .vertexBindingDescriptionCount = description.vertices ? 1u : 0u,
        .pVertexBindingDescriptions = &binding,
        .vertexAttributeDescriptionCount = description.vertices ? 4u : 0u,
        .pVertexAttributeDescriptions = attributes};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo rasterisation{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo multisampling{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineDepthStencilStateCreateInfo depth{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = true,
        .depthWriteEnable = true,
        .depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL};
    const VkPipelineColorBlendAttachmentState attachment{
        .colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                          VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT};
    const VkPipelineColorBlendStateCreateInfo blending{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1,
        .pAttachments = &attachment};
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = states};
    const VkFormat format = Canvas::FORMAT;
    const VkPipelineRenderingCreateInfo rendering{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1,
        .pColorAttachmentFormats = &format,
        .depthAttachmentFormat = VK_FORMAT_D32_SFLOAT};
    const VkGraphicsPipelineCreateInfo info{.sType =
                                                VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                            .pNext = &rendering,
                                            .stageCount = 2,
                                            .pStages = stages,
                                            .pVertexInputState = &input,
                                            .pInputAssemblyState = &assembly,
                                            .pViewportState = &viewport,
                                            .pRasterizationState = &rasterisation,
                                            .pMultisampleState = &multisampling,
                                            .pDepthStencilState = &depth,
                                            .pColorBlendState = &blending,
                                            .pDynamicState = &dynamic,
                                            .layout = pipeline.layout};
    check(vkCreateGraphicsPipelines(engine.device, VK_NULL_HANDLE, 1, &info, nullptr,
                                    &pipeline.handle),
          "create a pipeline");
    vkDestroyShaderModule(engine.device, vertex, nullptr);
    vkDestroyShaderModule(engine.device, fragment, nullptr);
    return pipeline;
}

void Pipeline::bind(VkCommandBuffer commands, const void* constants) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, handle);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0,
                            nullptr);
    vkCmdPushConstants(commands, layout, BOTH, 0, push_constants, constants);
}

void Pipeline::destroy(const Engine& engine) const {
    vkDestroyPipeline(engine.device, handle, nullptr);
    vkDestroyPipelineLayout(engine.device, layout, nullptr);
    for (const VkSampler sampler : samplers) vkDestroySampler(engine.device, sampler, nullptr);
    vkDestroyDescriptorPool(engine.device, pool, nullptr);
    vkDestroyDescriptorSetLayout(engine.device, set_layout, nullptr);
}
