#pragma once

#include <vulkan/vulkan.h>

// Every Vulkan function that the library calls, once, with what its page in the specification lists
// as return codes beside VK_SUCCESS ("Return Codes", Vulkan 1.3 and the extensions of its headers).
#define LOBELIA_MEMORY_CODES VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY
#define LOBELIA_CREATE_CODES LOBELIA_MEMORY_CODES, VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS_KHR
#define LOBELIA_LOSS_CODES LOBELIA_MEMORY_CODES, VK_ERROR_DEVICE_LOST
#define LOBELIA_PIPELINE_CODES                                                                     \
    LOBELIA_MEMORY_CODES, VK_ERROR_INVALID_SHADER_NV, VK_PIPELINE_COMPILE_REQUIRED_EXT

#define LOBELIA_SHIM_INSTANCE_FUNCTIONS(X)                                                         \
    X(vkCreateInstance, LOBELIA_MEMORY_CODES, VK_ERROR_INITIALIZATION_FAILED,                      \
      VK_ERROR_LAYER_NOT_PRESENT, VK_ERROR_EXTENSION_NOT_PRESENT, VK_ERROR_INCOMPATIBLE_DRIVER)    \
    X(vkCreateDevice, LOBELIA_LOSS_CODES, VK_ERROR_INITIALIZATION_FAILED,                          \
      VK_ERROR_EXTENSION_NOT_PRESENT, VK_ERROR_FEATURE_NOT_PRESENT, VK_ERROR_TOO_MANY_OBJECTS)     \
    X(vkDestroyInstance)                                                                           \
    X(vkEnumeratePhysicalDevices, LOBELIA_MEMORY_CODES, VK_ERROR_INITIALIZATION_FAILED,            \
      VK_INCOMPLETE)                                                                               \
    X(vkGetPhysicalDeviceFormatProperties)                                                         \
    X(vkGetPhysicalDeviceMemoryProperties)                                                         \
    X(vkGetPhysicalDeviceProperties2)                                                              \
    X(vkGetPhysicalDeviceQueueFamilyProperties)

#define LOBELIA_SHIM_DEVICE_FUNCTIONS(X)                                                           \
    X(vkAllocateCommandBuffers, LOBELIA_MEMORY_CODES)                                              \
    X(vkAllocateDescriptorSets, LOBELIA_MEMORY_CODES, VK_ERROR_FRAGMENTED_POOL,                    \
      VK_ERROR_OUT_OF_POOL_MEMORY)                                                                 \
    X(vkAllocateMemory, LOBELIA_CREATE_CODES, VK_ERROR_INVALID_EXTERNAL_HANDLE)                    \
    X(vkBeginCommandBuffer, LOBELIA_MEMORY_CODES)                                                  \
    X(vkBindBufferMemory, LOBELIA_CREATE_CODES)                                                    \
    X(vkBindImageMemory, LOBELIA_MEMORY_CODES)                                                     \
    X(vkCmdBeginRenderPass)                                                                        \
    X(vkCmdBindDescriptorSets)                                                                     \
    X(vkCmdBindPipeline)                                                                           \
    X(vkCmdBlitImage)                                                                              \
    X(vkCmdCopyBufferToImage)                                                                      \
    X(vkCmdCopyImageToBuffer)                                                                      \
    X(vkCmdDispatch)                                                                               \
    X(vkCmdDispatchBase)                                                                           \
    X(vkCmdDraw)                                                                                   \
    X(vkCmdEndRenderPass)                                                                          \
    X(vkCmdPipelineBarrier)                                                                        \
    X(vkCmdPushConstants)                                                                          \
    X(vkCmdResetQueryPool)                                                                         \
    X(vkCmdSetScissor)                                                                             \
    X(vkCmdSetViewport)                                                                            \
    X(vkCmdUpdateBuffer)                                                                           \
    X(vkCmdWriteTimestamp)                                                                         \
    X(vkCreateBuffer, LOBELIA_CREATE_CODES)                                                        \
    X(vkCreateBufferView, LOBELIA_MEMORY_CODES)                                                    \
    X(vkCreateCommandPool, LOBELIA_MEMORY_CODES)                                                   \
    X(vkCreateComputePipelines, LOBELIA_PIPELINE_CODES)                                            \
    X(vkCreateDescriptorPool, LOBELIA_MEMORY_CODES, VK_ERROR_FRAGMENTATION_EXT)                    \
    X(vkCreateDescriptorSetLayout, LOBELIA_MEMORY_CODES)                                           \
    X(vkCreateFence, LOBELIA_MEMORY_CODES)                                                         \
    X(vkCreateFramebuffer, LOBELIA_MEMORY_CODES)                                                   \
    X(vkCreateGraphicsPipelines, LOBELIA_PIPELINE_CODES)                                           \
    X(vkCreateImage, LOBELIA_CREATE_CODES, VK_ERROR_COMPRESSION_EXHAUSTED_EXT)                     \
    X(vkCreateImageView, LOBELIA_CREATE_CODES)                                                     \
    X(vkCreatePipelineLayout, LOBELIA_MEMORY_CODES)                                                \
    X(vkCreateQueryPool, LOBELIA_MEMORY_CODES)                                                     \
    X(vkCreateRenderPass, LOBELIA_MEMORY_CODES)                                                    \
    X(vkCreateSampler, LOBELIA_CREATE_CODES)                                                       \
    X(vkCreateShaderModule, LOBELIA_MEMORY_CODES, VK_ERROR_INVALID_SHADER_NV)                      \
    X(vkDestroyBuffer)                                                                             \
    X(vkDestroyBufferView)                                                                         \
    X(vkDestroyCommandPool)                                                                        \
    X(vkDestroyDescriptorPool)                                                                     \
    X(vkDestroyDescriptorSetLayout)                                                                \
    X(vkDestroyDevice)                                                                             \
    X(vkDestroyFence)                                                                              \
    X(vkDestroyFramebuffer)                                                                        \
    X(vkDestroyImage)                                                                              \
    X(vkDestroyImageView)                                                                          \
    X(vkDestroyPipeline)                                                                           \
    X(vkDestroyPipelineLayout)                                                                     \
    X(vkDestroyQueryPool)                                                                          \
    X(vkDestroyRenderPass)                                                                         \
    X(vkDestroySampler)                                                                            \
    X(vkDestroyShaderModule)                                                                       \
    X(vkDeviceWaitIdle, LOBELIA_LOSS_CODES)                                                        \
    X(vkEndCommandBuffer, LOBELIA_MEMORY_CODES)                                                    \
    X(vkFreeMemory)                                                                                \
    X(vkGetBufferMemoryRequirements)                                                               \
    X(vkGetDeviceQueue)                                                                            \
    X(vkGetImageMemoryRequirements)                                                                \
    X(vkGetQueryPoolResults, LOBELIA_LOSS_CODES, VK_NOT_READY)                                     \
    X(vkMapMemory, LOBELIA_MEMORY_CODES, VK_ERROR_MEMORY_MAP_FAILED)                               \
    X(vkQueueSubmit, LOBELIA_LOSS_CODES)                                                           \
    X(vkResetCommandPool, VK_ERROR_OUT_OF_DEVICE_MEMORY)                                           \
    X(vkResetFences, VK_ERROR_OUT_OF_DEVICE_MEMORY)                                                \
    X(vkUpdateDescriptorSets)                                                                      \
    X(vkWaitForFences, LOBELIA_LOSS_CODES, VK_TIMEOUT)

// Of an extension, so that the loader does not export them.
#define LOBELIA_SHIM_EXTENSION_FUNCTIONS(X)                                                        \
    X(vkCreateDebugUtilsMessengerEXT, VK_ERROR_OUT_OF_HOST_MEMORY)                                 \
    X(vkDestroyDebugUtilsMessengerEXT)

#define LOBELIA_SHIM_FUNCTIONS(X)                                                                  \
    LOBELIA_SHIM_INSTANCE_FUNCTIONS(X)                                                             \
    LOBELIA_SHIM_DEVICE_FUNCTIONS(X)                                                               \
    LOBELIA_SHIM_EXTENSION_FUNCTIONS(X)

namespace lobelia::test {

/// A Vulkan function, as a number.
enum class Call {
#define X(name, ...) name,
    LOBELIA_SHIM_FUNCTIONS(X)
#undef X
};

} // namespace lobelia::test
