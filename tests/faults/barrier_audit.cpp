#include "barrier_audit.h"

#include <algorithm>

namespace lobelia::test {

namespace {

constexpr std::uint64_t LEVEL = 4096; // more than an image has layers
constexpr Scope COPY_FROM{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT};
constexpr Scope COPY_TO{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT};

std::uint64_t number(const void* handle) {
    return reinterpret_cast<std::uint64_t>(handle);
}

} // namespace

std::vector<Part> BarrierAudit::parts(VkImage image, VkImageSubresourceRange range) const {
    const auto known = images_.find(image);
    const Image size = known == images_.end() ? Image{1, 1} : known->second;
    if (range.levelCount == VK_REMAINING_MIP_LEVELS)
        range.levelCount = size.levels - range.baseMipLevel;
    if (range.layerCount == VK_REMAINING_ARRAY_LAYERS)
        range.layerCount = size.layers - range.baseArrayLayer;
    std::vector<Part> all;
    for (std::uint32_t i = 0; i < range.levelCount; ++i) {
        const std::uint64_t begin = (range.baseMipLevel + i) * LEVEL + range.baseArrayLayer;
        all.push_back({number(image), begin, begin + range.layerCount});
    }
    return all;
}

Part BarrierAudit::part(VkImage image, const VkImageSubresourceLayers& layers) {
    const std::uint64_t begin = layers.mipLevel * LEVEL + layers.baseArrayLayer;
    return {number(image), begin, begin + layers.layerCount};
}

Part BarrierAudit::part(VkBuffer buffer, VkDeviceSize offset, VkDeviceSize size) const {
    const auto known = buffers_.find(buffer);
    const VkDeviceSize all = known == buffers_.end() ? offset : known->second;
    return {number(buffer), offset, size == VK_WHOLE_SIZE ? all : offset + size};
}

// Objects ------------------------------------------------------------------------------------

void BarrierAudit::see(Seen<Call::vkCreateImage>, VkDevice, const VkImageCreateInfo* info,
                       const VkAllocationCallbacks*, VkImage* image) {
    images_[*image] = {info->mipLevels, info->arrayLayers};
}
void BarrierAudit::see(Seen<Call::vkCreateImageView>, VkDevice, const VkImageViewCreateInfo* info,
                       const VkAllocationCallbacks*, VkImageView* view) {
    views_[*view] = {info->image, info->format, info->subresourceRange};
}
void BarrierAudit::see(Seen<Call::vkCreateBuffer>, VkDevice, const VkBufferCreateInfo* info,
                       const VkAllocationCallbacks*, VkBuffer* buffer) {
    buffers_[*buffer] = info->size;
}
void BarrierAudit::see(Seen<Call::vkCreateBufferView>, VkDevice, const VkBufferViewCreateInfo* info,
                       const VkAllocationCallbacks*, VkBufferView* view) {
    texels_[*view] = part(info->buffer, info->offset, info->range);
}
void BarrierAudit::see(Seen<Call::vkCreateSampler>, VkDevice, const VkSamplerCreateInfo* info,
                       const VkAllocationCallbacks*, VkSampler* sampler) {
    if (info->magFilter == VK_FILTER_LINEAR || info->minFilter == VK_FILTER_LINEAR)
        linear_.insert(*sampler);
    else
        linear_.erase(*sampler);
}
void BarrierAudit::see(Seen<Call::vkCreateShaderModule>, VkDevice,
                       const VkShaderModuleCreateInfo* info, const VkAllocationCallbacks*,
                       VkShaderModule* module) {
    modules_[*module].uses = shader_accesses({info->pCode, info->codeSize / sizeof(std::uint32_t)});
}
void BarrierAudit::see(Seen<Call::vkCreateComputePipelines>, VkDevice, VkPipelineCache,
                       std::uint32_t, const VkComputePipelineCreateInfo* info,
                       const VkAllocationCallbacks*, VkPipeline* pipeline) {
    pipelines_[*pipeline] = modules_[info->stage.module];
}
void BarrierAudit::see(Seen<Call::vkCreateGraphicsPipelines>, VkDevice, VkPipelineCache,
                       std::uint32_t, const VkGraphicsPipelineCreateInfo* info,
                       const VkAllocationCallbacks*, VkPipeline* pipeline) {
    for (std::uint32_t i = 0; i < info->stageCount; ++i) // only fragment shaders have bindings here
        if (info->pStages[i].stage == VK_SHADER_STAGE_FRAGMENT_BIT)
            pipelines_[*pipeline] = modules_[info->pStages[i].module];
}
void BarrierAudit::see(Seen<Call::vkCreateRenderPass>, VkDevice, const VkRenderPassCreateInfo* info,
                       const VkAllocationCallbacks*, VkRenderPass* pass) {
    passes_[*pass] = {{info->pAttachments, info->pAttachments + info->attachmentCount},
                      {info->pDependencies, info->pDependencies + info->dependencyCount}};
}
void BarrierAudit::see(Seen<Call::vkCreateFramebuffer>, VkDevice,
                       const VkFramebufferCreateInfo* info, const VkAllocationCallbacks*,
                       VkFramebuffer* target) {
    targets_[*target] = {info->pAttachments, info->pAttachments + info->attachmentCount};
}
void BarrierAudit::see(Seen<Call::vkBindBufferMemory>, VkDevice, VkBuffer buffer,
                       VkDeviceMemory memory, VkDeviceSize) {
    memory_[buffer] = memory;
}
void BarrierAudit::see(Seen<Call::vkMapMemory>, VkDevice, VkDeviceMemory memory, VkDeviceSize,
                       VkDeviceSize, VkMemoryMapFlags, void**) {
    mapped_.insert(memory);
}
void BarrierAudit::see(Seen<Call::vkFreeMemory>, VkDevice, VkDeviceMemory memory,
                       const VkAllocationCallbacks*) {
    mapped_.erase(memory);
}
void BarrierAudit::see(Seen<Call::vkDestroyImage>, VkDevice, VkImage image,
                       const VkAllocationCallbacks*) {
    history.forget(number(image));
}
void BarrierAudit::see(Seen<Call::vkDestroyBuffer>, VkDevice, VkBuffer buffer,
                       const VkAllocationCallbacks*) {
    history.forget(number(buffer));
    memory_.erase(buffer);
}

void BarrierAudit::see(Seen<Call::vkUpdateDescriptorSets>, VkDevice, std::uint32_t count,
                       const VkWriteDescriptorSet* writes, std::uint32_t,
                       const VkCopyDescriptorSet*) {
    for (const VkWriteDescriptorSet& write : std::span(writes, count)) {
        Bound bound{write.descriptorType, {}};
        if (write.pImageInfo) {
            const View& view = views_[write.pImageInfo->imageView];
            bound.parts = parts(view.image, view.range);
            if (write.descriptorType == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER &&
                linear_.contains(write.pImageInfo->sampler) &&
                view.format == VK_FORMAT_R32G32B32A32_SFLOAT)
                linear_floats.insert("binding " + std::to_string(write.dstBinding));
        } else if (write.pBufferInfo) {
            bound.parts = {part(write.pBufferInfo->buffer, write.pBufferInfo->offset,
                                write.pBufferInfo->range)};
        } else {
            bound.parts = {texels_[*write.pTexelBufferView]};
        }
        sets_[write.dstSet][write.dstBinding] = bound;
    }
}

// Commands -----------------------------------------------------------------------------------

void BarrierAudit::see(Seen<Call::vkCmdBindPipeline>, VkCommandBuffer, VkPipelineBindPoint point,
                       VkPipeline pipeline) {
    pipeline_[point] = pipeline;
}
void BarrierAudit::see(Seen<Call::vkCmdBindDescriptorSets>, VkCommandBuffer,
                       VkPipelineBindPoint point, VkPipelineLayout, std::uint32_t, std::uint32_t,
                       const VkDescriptorSet* sets, std::uint32_t, const std::uint32_t*) {
    set_[point] = sets[0];
}

void BarrierAudit::use_bindings(VkPipelineBindPoint point, VkPipelineStageFlags stage,
                                const std::string& what) {
    const std::string command = what + " " + std::to_string(++commands_);
    for (const bool writing : {false, true})
        for (const auto& [binding, use] : pipelines_[pipeline_[point]].uses) {
            const Bound& bound = sets_[set_[point]][binding];
            const bool storage = bound.type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER ||
                                 bound.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
            if (writing ? !(storage && use.writes) : storage && use.writes) continue;
            const VkAccessFlags accesses =
                bound.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER ? VK_ACCESS_UNIFORM_READ_BIT
                : !writing                                      ? VK_ACCESS_SHADER_READ_BIT
                : use.reads ? VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT
                            : VK_ACCESS_SHADER_WRITE_BIT;
            for (const Part& one : bound.parts)
                history.access(one, {stage, accesses}, writing,
                               command + " at binding " + std::to_string(binding));
        }
}
// Dispatches of one pass from different first workgroups are the pieces of one command.
void BarrierAudit::dispatch(bool may_be_a_piece) {
    const std::pair now{pipeline_[VK_PIPELINE_BIND_POINT_COMPUTE],
                        set_[VK_PIPELINE_BIND_POINT_COMPUTE]};
    if (!may_be_a_piece || dispatched_ != now) history.next_command();
    dispatched_ = now;
    use_bindings(VK_PIPELINE_BIND_POINT_COMPUTE, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, "dispatch");
}
void BarrierAudit::see(Seen<Call::vkCmdDispatch>, VkCommandBuffer, std::uint32_t, std::uint32_t,
                       std::uint32_t) {
    dispatch(false);
}
void BarrierAudit::see(Seen<Call::vkCmdDispatchBase>, VkCommandBuffer, std::uint32_t, std::uint32_t,
                       std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t) {
    dispatch(true);
}
void BarrierAudit::see(Seen<Call::vkCmdDraw>, VkCommandBuffer, std::uint32_t, std::uint32_t,
                       std::uint32_t, std::uint32_t) {
    history.next_command();
    use_bindings(VK_PIPELINE_BIND_POINT_GRAPHICS, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, "draw");
}

// The dependency with what is outside, or the implicit one, and the changes of layout.
void BarrierAudit::cross_render_pass(const PassOnTarget& begun, bool entering) {
    const RenderPass& pass = passes_[begun.pass];
    VkSubpassDependency across{};
    across.srcStageMask =
        entering ? VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT : VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    across.dstStageMask =
        entering ? VK_PIPELINE_STAGE_ALL_COMMANDS_BIT : VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT;
    (entering ? across.dstAccessMask : across.srcAccessMask) =
        VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    for (const VkSubpassDependency& dependency : pass.dependencies)
        if ((entering ? dependency.srcSubpass : dependency.dstSubpass) == VK_SUBPASS_EXTERNAL)
            across = dependency;
    const Scope first{across.srcStageMask, across.srcAccessMask};
    const Scope second{across.dstStageMask, across.dstAccessMask};
    history.depend(first, second);
    for (std::size_t i = 0; i < pass.attachments.size(); ++i) {
        const View& view = views_[targets_[begun.target][i]];
        const VkImageLayout inside = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        const VkImageLayout outside =
            entering ? pass.attachments[i].initialLayout : pass.attachments[i].finalLayout;
        for (const Part& one : parts(view.image, view.range)) {
            history.depend(one, first, second, outside != inside);
            history.next_command();
            if (entering)
                history.access(one,
                               {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT},
                               true, "a render pass");
        }
    }
}
void BarrierAudit::see(Seen<Call::vkCmdBeginRenderPass>, VkCommandBuffer,
                       const VkRenderPassBeginInfo* info, VkSubpassContents) {
    begun_ = {info->renderPass, info->framebuffer};
    cross_render_pass(begun_, true);
}
void BarrierAudit::see(Seen<Call::vkCmdEndRenderPass>, VkCommandBuffer) {
    cross_render_pass(begun_, false);
}

void BarrierAudit::see(Seen<Call::vkCmdCopyBufferToImage>, VkCommandBuffer, VkBuffer buffer,
                       VkImage image, VkImageLayout, std::uint32_t count,
                       const VkBufferImageCopy* regions) {
    history.next_command();
    for (const VkBufferImageCopy& region : std::span(regions, count)) {
        history.access(part(buffer, region.bufferOffset), COPY_FROM, false, "a copy");
        history.access(part(image, region.imageSubresource), COPY_TO, true, "a copy");
    }
}
void BarrierAudit::see(Seen<Call::vkCmdCopyImageToBuffer>, VkCommandBuffer, VkImage image,
                       VkImageLayout, VkBuffer buffer, std::uint32_t count,
                       const VkBufferImageCopy* regions) {
    history.next_command();
    for (const VkBufferImageCopy& region : std::span(regions, count)) {
        history.access(part(image, region.imageSubresource), COPY_FROM, false, "a copy");
        history.access(part(buffer, region.bufferOffset), COPY_TO, true, "a copy");
    }
}
void BarrierAudit::see(Seen<Call::vkCmdBlitImage>, VkCommandBuffer, VkImage from, VkImageLayout,
                       VkImage to, VkImageLayout, std::uint32_t count, const VkImageBlit* regions,
                       VkFilter) {
    history.next_command();
    for (const VkImageBlit& region : std::span(regions, count)) {
        history.access(part(from, region.srcSubresource), COPY_FROM, false, "a blit");
        history.access(part(to, region.dstSubresource), COPY_TO, true, "a blit");
    }
}
void BarrierAudit::see(Seen<Call::vkCmdUpdateBuffer>, VkCommandBuffer, VkBuffer buffer,
                       VkDeviceSize offset, VkDeviceSize size, const void*) {
    history.next_command();
    history.access(part(buffer, offset, size), COPY_TO, true, "an update");
}

void BarrierAudit::see(Seen<Call::vkCmdPipelineBarrier>, VkCommandBuffer,
                       VkPipelineStageFlags first, VkPipelineStageFlags second, VkDependencyFlags,
                       std::uint32_t memory_count, const VkMemoryBarrier* memories,
                       std::uint32_t buffer_count, const VkBufferMemoryBarrier* buffers,
                       std::uint32_t image_count, const VkImageMemoryBarrier* images) {
    dispatched_ = {};
    for (const VkImageMemoryBarrier& image : std::span(images, image_count))
        for (const Part& one : parts(image.image, image.subresourceRange))
            history.depend(one, {first, image.srcAccessMask}, {second, image.dstAccessMask},
                           image.oldLayout != image.newLayout);
    for (const VkBufferMemoryBarrier& buffer : std::span(buffers, buffer_count))
        history.depend(part(buffer.buffer, buffer.offset, buffer.size),
                       {first, buffer.srcAccessMask}, {second, buffer.dstAccessMask}, false);
    for (const VkMemoryBarrier& memory : std::span(memories, memory_count))
        history.depend({first, memory.srcAccessMask}, {second, memory.dstAccessMask});
    history.depend({first, 0}, {second, 0});
}

void BarrierAudit::see(Seen<Call::vkWaitForFences>, VkDevice, std::uint32_t, const VkFence*,
                       VkBool32, std::uint64_t) {
    std::vector<std::uint64_t> read;
    for (const auto& [buffer, memory] : memory_)
        if (mapped_.contains(memory)) read.push_back(number(buffer));
    history.finish(read);
}

} // namespace lobelia::test
