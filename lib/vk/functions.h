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
    X(vkCmdDispatchBase)                                                                           \
    X(vkCmdDraw)                                                                                   \
    X(vkCmdPipelineBarrier)                                                                        \
    X(vkCmdPushConstants)                                                                          \
    X(vkCmdSetScissor)                                                                             \
    X(vkCmdSetViewport)                                                                            \
    X(vkCmdUpdateBuffer)                                                                           \
    X(vkCmdWriteTimestamp)                                                                         \
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

// Of VK_EXT_debug_utils, null where the caller has not enabled it.
#define LOBELIA_DEBUG_FUNCTIONS(X)                                                                 \
    X(vkCmdBeginDebugUtilsLabelEXT)                                                                \
    X(vkCmdEndDebugUtilsLabelEXT)                                                                  \
    X(vkSetDebugUtilsObjectNameEXT)

namespace lobelia::vk {

struct Functions {
#define X(name) PFN_##name name = nullptr;
    LOBELIA_DEVICE_FUNCTIONS(X)
    LOBELIA_DEBUG_FUNCTIONS(X)
#undef X
};

/// The caller's device with its functions: what every object of the library is made from. It must
/// stay where it is while objects made from it live.
struct Context {
    Device device;
    Functions call;
};

/// Throws an Error where the device cannot be used.
Context load(const Device& device);

/// Tells the caller, where it wants to know.
inline void warn(const Context& context, const char* text) noexcept {
    if (context.device.on_warning) context.device.on_warning(text, context.device.on_warning_user);
}

} // namespace lobelia::vk
