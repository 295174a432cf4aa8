#pragma once

#include <lobelia/device.h>
#include <lobelia/result.h>

// Every device function the library calls, once. Core names, all of Vulkan 1.0 or 1.1.
#define LOBELIA_DEVICE_FUNCTIONS(X)                                                                \
    X(vkAllocateDescriptorSets)                                                                    \
    X(vkCmdBindDescriptorSets)                                                                     \
    X(vkCmdBindPipeline)                                                                           \
    X(vkCmdCopyBufferToImage)                                                                      \
    X(vkCmdDispatch)                                                                               \
    X(vkCmdDraw)                                                                                   \
    X(vkCmdPipelineBarrier)                                                                        \
    X(vkCmdPushConstants)                                                                          \
    X(vkCmdSetScissor)                                                                             \
    X(vkCmdSetViewport)                                                                            \
    X(vkCmdUpdateBuffer)                                                                           \
    X(vkCreateBufferView)                                                                          \
    X(vkCreateComputePipelines)                                                                    \
    X(vkCreateDescriptorPool)                                                                      \
    X(vkCreateDescriptorSetLayout)                                                                 \
    X(vkCreateGraphicsPipelines)                                                                   \
    X(vkCreateImageView)                                                                           \
    X(vkCreatePipelineLayout)                                                                      \
    X(vkCreateSampler)                                                                             \
    X(vkCreateShaderModule)                                                                        \
    X(vkDestroyBufferView)                                                                         \
    X(vkDestroyDescriptorPool)                                                                     \
    X(vkDestroyDescriptorSetLayout)                                                                \
    X(vkDestroyImageView)                                                                          \
    X(vkDestroyPipeline)                                                                           \
    X(vkDestroyPipelineLayout)                                                                     \
    X(vkDestroySampler)                                                                            \
    X(vkDestroyShaderModule)                                                                       \
    X(vkUpdateDescriptorSets)

namespace lobelia::vk {

struct Functions {
#define X(name) PFN_##name name = nullptr;
    LOBELIA_DEVICE_FUNCTIONS(X)
#undef X
};

/// The caller's device with its functions: what every object of the library is made from. It must
/// stay where it is while objects made from it live.
struct Context {
    Device device;
    Functions call;
};

Result<Context> load(const Device& device);

} // namespace lobelia::vk
