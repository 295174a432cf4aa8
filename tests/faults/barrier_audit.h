#pragma once

#include <set>
#include <span>
#include <type_traits>
#include <utility>

#include "access_history.h"
#include "functions.h"
#include "shader_accesses.h"

namespace lobelia::test {

template <Call id>
using Seen = std::integral_constant<Call, id>;

/// Watches the commands that are recorded and what they are bound to, and looks for two accesses
/// with a write among them and no barrier between: what the layers do not report between
/// dispatches. One queue; command buffers are submitted in the order in which they are recorded.
class BarrierAudit {
public:
    AccessHistory history;
    /// Images of 32-bit floats that were bound for linear filtering, which devices need not have.
    std::set<std::string> linear_floats;

    /// Of every call that succeeded, with its arguments.
    void see(Seen<Call::vkCreateImage>, VkDevice, const VkImageCreateInfo*,
             const VkAllocationCallbacks*, VkImage*);
    void see(Seen<Call::vkCreateImageView>, VkDevice, const VkImageViewCreateInfo*,
             const VkAllocationCallbacks*, VkImageView*);
    void see(Seen<Call::vkCreateBuffer>, VkDevice, const VkBufferCreateInfo*,
             const VkAllocationCallbacks*, VkBuffer*);
    void see(Seen<Call::vkCreateBufferView>, VkDevice, const VkBufferViewCreateInfo*,
             const VkAllocationCallbacks*, VkBufferView*);
    void see(Seen<Call::vkCreateSampler>, VkDevice, const VkSamplerCreateInfo*,
             const VkAllocationCallbacks*, VkSampler*);
    void see(Seen<Call::vkCreateShaderModule>, VkDevice, const VkShaderModuleCreateInfo*,
             const VkAllocationCallbacks*, VkShaderModule*);
    void see(Seen<Call::vkCreateComputePipelines>, VkDevice, VkPipelineCache, std::uint32_t,
             const VkComputePipelineCreateInfo*, const VkAllocationCallbacks*, VkPipeline*);
    void see(Seen<Call::vkCreateGraphicsPipelines>, VkDevice, VkPipelineCache, std::uint32_t,
             const VkGraphicsPipelineCreateInfo*, const VkAllocationCallbacks*, VkPipeline*);
    void see(Seen<Call::vkCreateRenderPass>, VkDevice, const VkRenderPassCreateInfo*,
             const VkAllocationCallbacks*, VkRenderPass*);
    void see(Seen<Call::vkCreateFramebuffer>, VkDevice, const VkFramebufferCreateInfo*,
             const VkAllocationCallbacks*, VkFramebuffer*);
    void see(Seen<Call::vkBindBufferMemory>, VkDevice, VkBuffer, VkDeviceMemory, VkDeviceSize);
    void see(Seen<Call::vkMapMemory>, VkDevice, VkDeviceMemory, VkDeviceSize, VkDeviceSize,
             VkMemoryMapFlags, void**);
    void see(Seen<Call::vkFreeMemory>, VkDevice, VkDeviceMemory, const VkAllocationCallbacks*);
    void see(Seen<Call::vkDestroyImage>, VkDevice, VkImage, const VkAllocationCallbacks*);
    void see(Seen<Call::vkDestroyBuffer>, VkDevice, VkBuffer, const VkAllocationCallbacks*);
    void see(Seen<Call::vkUpdateDescriptorSets>, VkDevice, std::uint32_t,
             const VkWriteDescriptorSet*, std::uint32_t, const VkCopyDescriptorSet*);

    void see(Seen<Call::vkCmdBindPipeline>, VkCommandBuffer, VkPipelineBindPoint, VkPipeline);
    void see(Seen<Call::vkCmdBindDescriptorSets>, VkCommandBuffer, VkPipelineBindPoint,
             VkPipelineLayout, std::uint32_t, std::uint32_t, const VkDescriptorSet*, std::uint32_t,
             const std::uint32_t*);
    void see(Seen<Call::vkCmdDispatch>, VkCommandBuffer, std::uint32_t, std::uint32_t,
             std::uint32_t);
    void see(Seen<Call::vkCmdDispatchBase>, VkCommandBuffer, std::uint32_t, std::uint32_t,
             std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t);
    void see(Seen<Call::vkCmdDraw>, VkCommandBuffer, std::uint32_t, std::uint32_t, std::uint32_t,
             std::uint32_t);
    void see(Seen<Call::vkCmdBeginRenderPass>, VkCommandBuffer, const VkRenderPassBeginInfo*,
             VkSubpassContents);
    void see(Seen<Call::vkCmdEndRenderPass>, VkCommandBuffer);
    void see(Seen<Call::vkCmdCopyBufferToImage>, VkCommandBuffer, VkBuffer, VkImage, VkImageLayout,
             std::uint32_t, const VkBufferImageCopy*);
    void see(Seen<Call::vkCmdCopyImageToBuffer>, VkCommandBuffer, VkImage, VkImageLayout, VkBuffer,
             std::uint32_t, const VkBufferImageCopy*);
    void see(Seen<Call::vkCmdBlitImage>, VkCommandBuffer, VkImage, VkImageLayout, VkImage,
             VkImageLayout, std::uint32_t, const VkImageBlit*, VkFilter);
    void see(Seen<Call::vkCmdUpdateBuffer>, VkCommandBuffer, VkBuffer, VkDeviceSize, VkDeviceSize,
             const void*);
    void see(Seen<Call::vkCmdPipelineBarrier>, VkCommandBuffer, VkPipelineStageFlags,
             VkPipelineStageFlags, VkDependencyFlags, std::uint32_t, const VkMemoryBarrier*,
             std::uint32_t, const VkBufferMemoryBarrier*, std::uint32_t,
             const VkImageMemoryBarrier*);
    void see(Seen<Call::vkWaitForFences>, VkDevice, std::uint32_t, const VkFence*, VkBool32,
             std::uint64_t);

private:
    struct Image {
        std::uint32_t levels, layers;
    };
    struct View {
        VkImage image;
        VkFormat format;
        VkImageSubresourceRange range;
    };
    struct Bound { // to a binding: parts, and how a shader gets at them
        VkDescriptorType type;
        std::vector<Part> parts;
    };
    struct Shaders {
        std::map<std::uint32_t, BindingUse> uses; // by binding
    };
    struct PassOnTarget {
        VkRenderPass pass;
        VkFramebuffer target;
    };
    struct RenderPass {
        std::vector<VkAttachmentDescription> attachments;
        std::vector<VkSubpassDependency> dependencies;
    };

    std::vector<Part> parts(VkImage image, VkImageSubresourceRange range) const;
    static Part part(VkImage image, const VkImageSubresourceLayers& layers);
    Part part(VkBuffer buffer, VkDeviceSize offset = 0, VkDeviceSize size = VK_WHOLE_SIZE) const;
    void use_bindings(VkPipelineBindPoint point, VkPipelineStageFlags stage,
                      const std::string& what);
    void dispatch(bool may_be_a_piece);
    void cross_render_pass(const PassOnTarget& begun, bool entering);

    std::map<VkImage, Image> images_;
    std::map<VkImageView, View> views_;
    std::map<VkBuffer, VkDeviceSize> buffers_;
    std::map<VkBufferView, Part> texels_;
    std::map<VkBuffer, VkDeviceMemory> memory_;
    std::set<VkDeviceMemory> mapped_;
    std::set<VkSampler> linear_;
    std::map<VkShaderModule, Shaders> modules_;
    std::map<VkPipeline, Shaders> pipelines_;
    std::map<VkRenderPass, RenderPass> passes_;
    std::map<VkFramebuffer, std::vector<VkImageView>> targets_;
    std::map<VkDescriptorSet, std::map<std::uint32_t, Bound>> sets_;
    std::map<VkPipelineBindPoint, VkPipeline> pipeline_; // bound
    std::map<VkPipelineBindPoint, VkDescriptorSet> set_;
    std::pair<VkPipeline, VkDescriptorSet> dispatched_{}; // last, with no barrier since
    PassOnTarget begun_{};
    std::size_t commands_ = 0; // recorded, for messages
};

} // namespace lobelia::test
