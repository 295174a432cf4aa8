#include "colour_pass.h"

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

Outcome<OwnedRenderPass> make_colour_pass(VkDevice device, VkFormat format,
                                          VkImageLayout final_layout, bool keeps) {
    const VkAttachmentDescription attachment{
        .format = format,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .loadOp = keeps ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_DONT_CARE,
        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
        .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
        .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
        .initialLayout = keeps ? final_layout : VK_IMAGE_LAYOUT_UNDEFINED,
        .finalLayout = final_layout};
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                       .colorAttachmentCount = 1,
                                       .pColorAttachments = &reference};
    // What read the attachment before is done, and what reads it later sees it. A swapchain's image
    // is waited for at COLOR_ATTACHMENT_OUTPUT.
    const VkPipelineStageFlags readers = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT |
                                         VK_PIPELINE_STAGE_TRANSFER_BIT |
                                         VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    const VkAccessFlags written = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    const VkSubpassDependency dependencies[] = {
        {.srcSubpass = VK_SUBPASS_EXTERNAL,
         .dstSubpass = 0,
         .srcStageMask = readers,
         .dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .srcAccessMask = written,
         .dstAccessMask = written | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT},
        {.srcSubpass = 0,
         .dstSubpass = VK_SUBPASS_EXTERNAL,
         .srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .dstStageMask = readers,
         .srcAccessMask = written,
         .dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_TRANSFER_READ_BIT | written}};
    const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                      .attachmentCount = 1,
                                      .pAttachments = &attachment,
                                      .subpassCount = 1,
                                      .pSubpasses = &subpass,
                                      .dependencyCount = 2,
                                      .pDependencies = dependencies};
    VkRenderPass handle = VK_NULL_HANDLE;
    const VkResult code = vkCreateRenderPass(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return vulkan_failure("create a render pass", code);
    return OwnedRenderPass(device, handle);
}

Outcome<OwnedFramebuffer> make_framebuffer(VkDevice device, VkRenderPass pass, VkImageView view,
                                           VkExtent2D extent) {
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = pass,
                                       .attachmentCount = 1,
                                       .pAttachments = &view,
                                       .width = extent.width,
                                       .height = extent.height,
                                       .layers = 1};
    VkFramebuffer handle = VK_NULL_HANDLE;
    const VkResult code = vkCreateFramebuffer(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return vulkan_failure("create a framebuffer", code);
    return OwnedFramebuffer(device, handle);
}

void record_colour_pass(VkCommandBuffer commands, VkRenderPass pass, VkFramebuffer framebuffer,
                        VkExtent2D extent, const std::function<void(VkCommandBuffer)>& draw) {
    const VkRenderPassBeginInfo begin{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                      .renderPass = pass,
                                      .framebuffer = framebuffer,
                                      .renderArea = {{0, 0}, extent}};
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    draw(commands);
    vkCmdEndRenderPass(commands);
}

} // namespace lobelia::cli
