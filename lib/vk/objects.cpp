#include "vk/objects.h"

namespace lobelia::vk {

ShaderModule make_shader_module(const Context& context, std::span<const std::uint32_t> spirv) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = spirv.size_bytes(),
                                        .pCode = spirv.data()};
    return make<ShaderModule>(context, context.call.vkCreateShaderModule, info,
                              "create shader module");
}

Sampler make_sampler(const Context& context, VkFilter filter) {
    const bool linear = filter == VK_FILTER_LINEAR;
    const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = filter,
                                   .minFilter = filter,
                                   .mipmapMode = linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                        : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                   .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                   .maxLod = VK_LOD_CLAMP_NONE};
    return make<Sampler>(context, context.call.vkCreateSampler, info, "create sampler");
}

Interface make_interface(const Context& context, const char* name, VkShaderStageFlags stages,
                         std::span<const VkDescriptorType> bindings,
                         std::uint32_t push_constant_size) {
    std::vector<VkDescriptorSetLayoutBinding> entries;
    for (const VkDescriptorType type : bindings)
        entries.push_back({std::uint32_t(entries.size()), type, 1, stages, nullptr});
    const VkDescriptorSetLayoutCreateInfo set_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = std::uint32_t(entries.size()),
        .pBindings = entries.data()};
    SetLayout set_layout = make<SetLayout>(context, context.call.vkCreateDescriptorSetLayout,
                                           set_info, "create descriptor set layout");

    const VkPushConstantRange range{stages, 0, push_constant_size};
    const VkDescriptorSetLayout handle = set_layout.get();
    const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .setLayoutCount = 1,
                                          .pSetLayouts = &handle,
                                          .pushConstantRangeCount = push_constant_size > 0,
                                          .pPushConstantRanges = &range};
    PipelineLayout layout = make<PipelineLayout>(context, context.call.vkCreatePipelineLayout, info,
                                                 "create pipeline layout");
    set_name(context, VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, handle, name);
    set_name(context, VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout.get(), name);
    return {std::move(set_layout), std::move(layout)};
}

DescriptorSets make_descriptor_sets(const Context& context, const Interface& interface,
                                    std::span<const VkDescriptorType> bindings,
                                    std::uint32_t sets) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (const VkDescriptorType type : bindings) sizes.push_back({type, sets});
    const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = sets,
                                          .poolSizeCount = std::uint32_t(sizes.size()),
                                          .pPoolSizes = sizes.data()};
    DescriptorPool pool = make<DescriptorPool>(context, context.call.vkCreateDescriptorPool, info,
                                               "create descriptor pool");

    const std::vector<VkDescriptorSetLayout> layouts(sets, interface.set_layout.get());
    DescriptorSets result{std::move(pool), std::vector<VkDescriptorSet>(sets)};
    const VkDescriptorSetAllocateInfo allocation{.sType =
                                                     VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                 .descriptorPool = result.pool.get(),
                                                 .descriptorSetCount = sets,
                                                 .pSetLayouts = layouts.data()};
    check(context.call.vkAllocateDescriptorSets(context.device.handle, &allocation,
                                                result.sets.data()),
          "allocate descriptor sets");
    return result;
}

DescriptorSets make_descriptor_set(const Context& context, const Interface& interface,
                                   std::span<const VkDescriptorType> bindings,
                                   std::span<const Resource> resources) {
    DescriptorSets made = make_descriptor_sets(context, interface, bindings, 1);
    write_descriptor_set(context, made.sets[0], bindings, resources);
    return made;
}

void write_descriptor_set(const Context& context, VkDescriptorSet set,
                          std::span<const VkDescriptorType> bindings,
                          std::span<const Resource> resources) {
    std::vector<VkWriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < bindings.size(); ++i)
        writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                          .dstSet = set,
                          .dstBinding = i,
                          .descriptorCount = 1,
                          .descriptorType = bindings[i],
                          .pImageInfo = &resources[i].image,
                          .pBufferInfo = &resources[i].buffer,
                          .pTexelBufferView = &resources[i].texels});
    context.call.vkUpdateDescriptorSets(context.device.handle, std::uint32_t(writes.size()),
                                        writes.data(), 0, nullptr);
}

} // namespace lobelia::vk
