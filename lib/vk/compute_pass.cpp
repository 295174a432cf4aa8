#include "vk/compute_pass.h"

#include <algorithm>

namespace lobelia::vk {

ComputePass make_compute_pass(const Context& context, const ComputePassDescription& description) {
    Interface interface = make_interface(context, description.name, VK_SHADER_STAGE_COMPUTE_BIT,
                                         description.bindings, description.push_constant_size);
    const ShaderModule module = make_shader_module(context, description.spirv);

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < description.constants.size(); ++i)
        entries.push_back({i, i * 4, 4});
    const VkSpecializationInfo constants{std::uint32_t(entries.size()), entries.data(),
                                         description.constants.size_bytes(),
                                         description.constants.data()};
    const VkComputePipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .flags = VK_PIPELINE_CREATE_DISPATCH_BASE_BIT, // a pass may be recorded in pieces
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module.get(),
                  .pName = "main",
                  .pSpecializationInfo = &constants},
        .layout = interface.layout.get()};
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(context.call.vkCreateComputePipelines(context.device.handle,
                                                context.device.pipeline_cache, 1, &info,
                                                context.device.allocator, &pipeline),
          "create compute pipeline");
    set_name(context, VK_OBJECT_TYPE_PIPELINE, pipeline, description.name);
    return {description.name, std::move(interface), Pipeline(context, pipeline)};
}

void dispatch_pieces(const Context& context, VkCommandBuffer commands, const Groups& groups,
                     std::uint32_t first, std::uint32_t count) {
    if (count == groups.pieces()) {
        context.call.vkCmdDispatch(commands, groups.x, groups.y, groups.z);
    } else if (groups.y * groups.z == 1) {
        context.call.vkCmdDispatchBase(commands, first, 0, 0, count, 1, 1);
    } else {
        while (count > 0) { // layer by layer
            const std::uint32_t row = first % groups.y;
            const std::uint32_t rows = std::min(count, groups.y - row);
            context.call.vkCmdDispatchBase(commands, 0, row, first / groups.y, groups.x, rows, 1);
            first += rows;
            count -= rows;
        }
    }
}

void image_barrier(const Context& context, VkCommandBuffer commands, VkImage image,
                   const ImageUse& from, const ImageUse& to, std::uint32_t first_level,
                   std::uint32_t levels) {
    const VkImageMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                       .srcAccessMask = from.access,
                                       .dstAccessMask = to.access,
                                       .oldLayout = from.layout,
                                       .newLayout = to.layout,
                                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                       .image = image,
                                       .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, first_level,
                                                            levels, 0, VK_REMAINING_ARRAY_LAYERS}};
    context.call.vkCmdPipelineBarrier(commands, from.stage, to.stage, 0, 0, nullptr, 0, nullptr, 1,
                                      &barrier);
}

namespace {

ImageView make_view(const Context& context, VkImage image, VkFormat format, VkImageViewType type,
                    const VkImageSubresourceRange& range) {
    const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     .image = image,
                                     .viewType = type,
                                     .format = format,
                                     .subresourceRange = range};
    return make<ImageView>(context, context.call.vkCreateImageView, info, "create image view");
}

} // namespace

ImageView make_level_view(const Context& context, VkImage image, VkFormat format,
                          VkImageViewType type, std::uint32_t level) {
    const std::uint32_t layers = type == VK_IMAGE_VIEW_TYPE_2D ? 1 : VK_REMAINING_ARRAY_LAYERS;
    return make_view(context, image, format, type,
                     {VK_IMAGE_ASPECT_COLOR_BIT, level, 1, 0, layers});
}

ImageView make_layers_view(const Context& context, VkImage image, VkFormat format,
                           std::uint32_t first_layer, std::uint32_t layers) {
    return make_view(context, image, format, VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                     {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, first_layer, layers});
}

ImageView make_cube_view(const Context& context, VkImage image, VkFormat format,
                         std::uint32_t levels) {
    return make_view(context, image, format, VK_IMAGE_VIEW_TYPE_CUBE,
                     {VK_IMAGE_ASPECT_COLOR_BIT, 0, levels, 0, 6});
}

void memory_barrier(const Context& context, VkCommandBuffer commands,
                    VkPipelineStageFlags from_stage, VkAccessFlags from,
                    VkPipelineStageFlags to_stage, VkAccessFlags to) {
    const VkMemoryBarrier barrier{
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER, .srcAccessMask = from, .dstAccessMask = to};
    context.call.vkCmdPipelineBarrier(commands, from_stage, to_stage, 0, 1, &barrier, 0, nullptr, 0,
                                      nullptr);
}

} // namespace lobelia::vk
