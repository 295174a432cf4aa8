#include <bit>
#include <cstdio>

#include "engine.h"

void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
                VkImageAspectFlags aspect) {
    const VkImageMemoryBarrier barrier{
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
        .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
        .dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image,
        .subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1,
                         &barrier);
}

Canvas Canvas::create(const Engine& engine, std::uint32_t width, std::uint32_t height) {
    return {
        width, height,
        engine.make_image(
            {.format = FORMAT,
             .width = width,
             .height = height,
             .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}),
        engine.make_buffer(VkDeviceSize(width) * height * 16, VK_BUFFER_USAGE_TRANSFER_DST_BIT)};
}

void Canvas::begin(VkCommandBuffer commands, const Image* depth) const {
    transition(commands, image.handle, VK_IMAGE_LAYOUT_UNDEFINED,
               VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    const VkRenderingAttachmentInfo colour{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = image.view,
                                           .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                           .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    if (depth)
        transition(commands, depth->handle, VK_IMAGE_LAYOUT_UNDEFINED,
                   VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, VK_IMAGE_ASPECT_DEPTH_BIT);
    const VkRenderingAttachmentInfo distance{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                             .imageView = depth ? depth->view : VK_NULL_HANDLE,
                                             .imageLayout =
                                                 VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                                             .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                             .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                             .clearValue = {.depthStencil = {1, 0}}};
    const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                    .renderArea = {{0, 0}, {width, height}},
                                    .layerCount = 1,
                                    .colorAttachmentCount = 1,
                                    .pColorAttachments = &colour,
                                    .pDepthAttachment = depth ? &distance : nullptr};
    vkCmdBeginRendering(commands, &rendering);
    const VkViewport viewport{0, 0, float(width), float(height), 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
}

void Canvas::end(VkCommandBuffer commands) const {
    vkCmdEndRendering(commands);
    transition(commands, image.handle, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
}

void Canvas::read_back(VkCommandBuffer commands) const {
    const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                   .imageExtent = {width, height, 1}};
    vkCmdCopyImageToBuffer(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           pixels.handle, 1, &region);
    const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                  .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
}

void Canvas::write(const char* path, std::uint32_t samples) const {
    std::FILE* const file = std::fopen(path, "wb");
    if (!file) fail("open the picture's file");
    const std::size_t columns = width / samples, rows = height / samples;
    std::fprintf(file, "PF\n%zu %zu\n%s\n", columns, rows,
                 std::endian::native == std::endian::little ? "-1.0" : "1.0");
    const float* const rgba = static_cast<const float*>(pixels.data);
    for (std::size_t y = rows; y-- > 0;) // from the lowest row up
        for (std::size_t x = 0; x < columns; ++x) {
            float mean[3] = {};
            for (std::size_t i = 0; i < std::size_t(samples) * samples; ++i)
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const std::size_t row = y * samples + i / samples;
                    const std::size_t column = x * samples + i % samples;
                    mean[channel] += rgba[4 * (row * width + column) + channel];
                }
            for (float& value : mean) value /= float(samples * samples);
            std::fwrite(mean, sizeof mean, 1, file);
        }
    if (std::fclose(file) != 0) fail("write the picture");
}

void Canvas::destroy(const Engine& engine) const {
    engine.destroy(image);
    engine.destroy(pixels);
}
