#include "vk/compute_pass.h"

namespace lobelia::vk {

Result<ComputePass> make_compute_pass(const Context& context,
                                      const ComputePassDescription& description) {
    auto interface = make_interface(context, VK_SHADER_STAGE_COMPUTE_BIT, description.bindings,
                                    description.push_constant_size);
    if (!interface) return interface.error();
    auto module = make_shader_module(context, description.spirv);
    if (!module) return module.error();

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < description.constants.size(); ++i)
        entries.push_back({i, i * 4, 4});
    const VkSpecializationInfo constants{std::uint32_t(entries.size()), entries.data(),
                                         description.constants.size_bytes(),
                                         description.constants.data()};
    const VkComputePipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module->get(),
                  .pName = "main",
                  .pSpecializationInfo = &constants},
        .layout = interface->layout.get()};
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult code = context.call.vkCreateComputePipelines(
        context.device.handle, context.device.pipeline_cache, 1, &info, context.device.allocator,
        &pipeline);
    if (code != VK_SUCCESS) return Error{code, "create compute pipeline"};
    return ComputePass{std::move(*interface), Pipeline(context, pipeline)};
}

void memory_barrier(const Context& context, VkCommandBuffer commands, VkPipelineStageFlags from_stage,
                    VkAccessFlags from, VkPipelineStageFlags to_stage, VkAccessFlags to) {
    const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .srcAccessMask = from,
                                  .dstAccessMask = to};
    context.call.vkCmdPipelineBarrier(commands, from_stage, to_stage, 0, 1, &barrier, 0, nullptr, 0,
                                      nullptr);
}

} // namespace lobelia::vk
