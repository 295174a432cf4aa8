#include "host/timestamps.h"

#include "host/gpu_instance.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t COUNT = 2; // one before and one after

} // namespace

Outcome<Timestamps> Timestamps::create(const HostContext& context, std::uint32_t valid_bits,
                                       float period) {
    Timestamps timestamps;
    if (valid_bits == 0) return timestamps;
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = COUNT};
    VkQueryPool pool = VK_NULL_HANDLE;
    const VkResult code =
        context.call.vkCreateQueryPool(context.device.handle, &info, nullptr, &pool);
    if (code != VK_SUCCESS) return failed("create a query pool", code);
    timestamps.context_ = &context;
    timestamps.pool_ = {context, pool};
    timestamps.mask_ = ~std::uint64_t(0) >> (64 - valid_bits);
    timestamps.period_ = double(period);
    return timestamps;
}

void Timestamps::record_begin(VkCommandBuffer commands) const {
    if (!context_) return;
    context_->call.vkCmdResetQueryPool(commands, pool_.get(), 0, COUNT);
    context_->call.vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, pool_.get(), 0);
    // Once there were draws, lavapipe takes a timestamp only when something makes it flush.
    context_->call.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                        VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0,
                                        nullptr, 0, nullptr);
}

void Timestamps::record_end(VkCommandBuffer commands) const {
    if (!context_) return;
    context_->call.vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_.get(),
                                       1);
}

Outcome<std::optional<double>> Timestamps::milliseconds() const {
    if (!context_) return std::optional<double>();
    std::uint64_t ticks[COUNT] = {};
    const VkResult code = context_->call.vkGetQueryPoolResults(
        context_->device.handle, pool_.get(), 0, COUNT, sizeof ticks, ticks, sizeof ticks[0],
        VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    if (code != VK_SUCCESS) return failed("read timestamps", code);
    return std::optional(1e-6 * period_ * double((ticks[1] - ticks[0]) & mask_));
}

} // namespace lobelia::host
