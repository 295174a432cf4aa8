#pragma once

#include <functional>

#include <lobelia/host/gpu.h>

#include "owned.h"

namespace lobelia::cli {

/// A render pass with one colour attachment that is written whole and left in `final_layout`,
/// visible to fragment shaders and transfers; with `keeps`, what is not written stays, of an image
/// that is in that layout.
host::Outcome<OwnedRenderPass> make_colour_pass(VkDevice device, VkFormat format,
                                                VkImageLayout final_layout, bool keeps = false);

/// A framebuffer of one attachment.
host::Outcome<OwnedFramebuffer> make_framebuffer(VkDevice device, VkRenderPass pass,
                                                 VkImageView view, VkExtent2D extent);

/// Records the render pass around `draw`.
void record_colour_pass(VkCommandBuffer commands, VkRenderPass pass, VkFramebuffer framebuffer,
                        VkExtent2D extent, const std::function<void(VkCommandBuffer)>& draw);

} // namespace lobelia::cli
