#include <bit>

#include "host/averages.h"
#include "host/warm_cost.h"

namespace lobelia::host {

namespace {

void record_mip_chain(const Gpu& gpu, VkCommandBuffer commands, const GpuImage& cube) {
    const auto blit = reinterpret_cast<PFN_vkCmdBlitImage>(
        gpu.device().get_device_proc_addr(gpu.device().handle, "vkCmdBlitImage"));
    const GpuImageDescription& shape = cube.description();
    for (std::uint32_t level = 1; level < shape.levels; ++level) {
        record_layout_change(gpu, commands, cube, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
        const auto from = std::int32_t(shape.width >> (level - 1)), to = from / 2;
        const VkImageBlit region{
            .srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level - 1, 0, shape.layers},
            .srcOffsets = {{}, {from, from, 1}},
            .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, shape.layers},
            .dstOffsets = {{}, {to, to, 1}}};
        blit(commands, cube.handle(), VK_IMAGE_LAYOUT_GENERAL, cube.handle(),
             VK_IMAGE_LAYOUT_GENERAL, 1, &region, VK_FILTER_LINEAR);
    }
}

} // namespace

Outcome<Cost> measure_mip_chain(Gpu& gpu, std::uint32_t face) {
    const auto cube = gpu.create_image({.width = face,
                                        .height = face,
                                        .layers = 6,
                                        .levels = std::uint32_t(std::bit_width(face)),
                                        .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                                 VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                                 VK_IMAGE_USAGE_SAMPLED_BIT, // which its view needs
                                        .cube = true});
    if (!cube) return cube.error();
    const auto made = gpu.submit([&](VkCommandBuffer commands) {
        record_layout_change(gpu, commands, *cube, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_GENERAL);
    });
    if (!made) return made.error();
    const TimedWork work{[&](PassReport& report) {
        return run_pass(gpu, report,
                        [&](VkCommandBuffer commands) { record_mip_chain(gpu, commands, *cube); });
    }};
    const auto costs = warm_costs(gpu, {&work, 1});
    if (!costs) return costs.error();
    Cost cost = costs->front();
    cost.dispatches = cube->description().levels - 1;
    cost.bytes = 2 * image_bytes(*cube); // the last level is not read and the first not written
    return cost;
}

} // namespace lobelia::host
