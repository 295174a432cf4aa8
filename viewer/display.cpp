#include "display.h"

#include <iterator>

#include "display_pipeline.h"
#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // first picture
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // second picture
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // reference
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // its pixels that are known
};
constexpr std::uint32_t BINDING_COUNT = std::uint32_t(std::size(BINDINGS));

} // namespace

Outcome<Display> Display::create(VkDevice device, VkRenderPass pass) {
    Display display(device, pass);
    if (const auto made = display.make_set(); !made) return made.error();
    if (const auto made = display.make_layout(); !made) return made.error();
    return display;
}

Outcome<Done> Display::make_set() {
    const VkSamplerCreateInfo sampler_info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    VkSampler sampler = VK_NULL_HANDLE;
    VkResult code = vkCreateSampler(device_, &sampler_info, nullptr, &sampler);
    if (code != VK_SUCCESS) return vulkan_failure("create a sampler", code);
    sampler_ = {device_, sampler};

    VkDescriptorSetLayoutBinding bindings[BINDING_COUNT];
    for (std::uint32_t i = 0; i < BINDING_COUNT; ++i)
        bindings[i] = {i, BINDINGS[i], 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    const VkDescriptorSetLayoutCreateInfo set_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = BINDING_COUNT,
        .pBindings = bindings};
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    code = vkCreateDescriptorSetLayout(device_, &set_info, nullptr, &set_layout);
    if (code != VK_SUCCESS) return vulkan_failure("create a descriptor set layout", code);
    set_layout_ = {device_, set_layout};

    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1}};
    const VkDescriptorPoolCreateInfo pool_info{.sType =
                                                   VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                               .maxSets = 1,
                                               .poolSizeCount = 2,
                                               .pPoolSizes = sizes};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    code = vkCreateDescriptorPool(device_, &pool_info, nullptr, &pool);
    if (code != VK_SUCCESS) return vulkan_failure("create a descriptor pool", code);
    pool_ = {device_, pool};
    const VkDescriptorSetAllocateInfo allocation{.sType =
                                                     VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                 .descriptorPool = pool,
                                                 .descriptorSetCount = 1,
                                                 .pSetLayouts = &set_layout};
    code = vkAllocateDescriptorSets(device_, &allocation, &set_);
    if (code != VK_SUCCESS) return vulkan_failure("allocate a descriptor set", code);
    return Done{};
}

Outcome<Done> Display::make_layout() {
    const VkPushConstantRange range{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(DisplayParams)};
    const VkDescriptorSetLayout set_layout = set_layout_.get();
    const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .setLayoutCount = 1,
                                          .pSetLayouts = &set_layout,
                                          .pushConstantRangeCount = 1,
                                          .pPushConstantRanges = &range};
    VkPipelineLayout layout = VK_NULL_HANDLE;
    const VkResult code = vkCreatePipelineLayout(device_, &info, nullptr, &layout);
    if (code != VK_SUCCESS) return vulkan_failure("create a pipeline layout", code);
    layout_ = {device_, layout};
    return Done{};
}

Outcome<Done> Display::bind(const DisplaySources& sources, const DisplayVariant& variant) {
    auto found = pipelines_.find(variant);
    if (found == pipelines_.end()) {
        auto made = make_display_pipeline(device_, pass_, layout_.get(), variant);
        if (!made) return made.error();
        found = pipelines_.emplace(variant, std::move(*made)).first;
    }
    pipeline_ = found->second.get();
    const VkImageView views[] = {sources.first, sources.second, sources.reference};
    VkDescriptorImageInfo images[std::size(views)];
    VkWriteDescriptorSet writes[BINDING_COUNT];
    for (std::uint32_t i = 0; i < BINDING_COUNT; ++i)
        writes[i] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                     .dstSet = set_,
                     .dstBinding = i,
                     .descriptorCount = 1,
                     .descriptorType = BINDINGS[i]};
    for (std::uint32_t i = 0; i < std::size(views); ++i) {
        images[i] = {sampler_.get(), views[i], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        writes[i].pImageInfo = &images[i];
    }
    const VkDescriptorBufferInfo known{sources.known, 0, VK_WHOLE_SIZE};
    writes[BINDING_COUNT - 1].pBufferInfo = &known;
    vkUpdateDescriptorSets(device_, BINDING_COUNT, writes, 0, nullptr);
    return Done{};
}

void Display::record(VkCommandBuffer commands, const DisplayParams& params,
                     VkExtent2D extent) const {
    const VkViewport viewport{0.0f, 0.0f, float(extent.width), float(extent.height), 0.0f, 1.0f};
    const VkRect2D scissor{{0, 0}, extent};
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_,
                            0, nullptr);
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof params,
                       &params);
    vkCmdDraw(commands, 3, 1, 0, 0);
}

} // namespace lobelia::cli
