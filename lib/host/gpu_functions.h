#pragma once

#include <lobelia/device.h>

#include "vk/unique.h"

// The Vulkan functions of lobelia::host beyond those of the core, each once. First what destroys
// what they are loaded for, should another not be there.
#define LOBELIA_HOST_INSTANCE_FUNCTIONS(X)                                                         \
    X(vkDestroyInstance)                                                                           \
    X(vkCreateDevice)                                                                              \
    X(vkEnumeratePhysicalDevices)                                                                  \
    X(vkGetDeviceProcAddr)                                                                         \
    X(vkGetPhysicalDeviceFormatProperties)                                                         \
    X(vkGetPhysicalDeviceMemoryProperties)                                                         \
    X(vkGetPhysicalDeviceProperties2)                                                              \
    X(vkGetPhysicalDeviceQueueFamilyProperties)

#define LOBELIA_HOST_DEVICE_FUNCTIONS(X)                                                           \
    X(vkDestroyDevice)                                                                             \
    X(vkAllocateCommandBuffers)                                                                    \
    X(vkAllocateMemory)                                                                            \
    X(vkBeginCommandBuffer)                                                                        \
    X(vkBindBufferMemory)                                                                          \
    X(vkBindImageMemory)                                                                           \
    X(vkCmdBlitImage)                                                                              \
    X(vkCmdCopyBufferToImage)                                                                      \
    X(vkCmdCopyImageToBuffer)                                                                      \
    X(vkCmdPipelineBarrier)                                                                        \
    X(vkCmdResetQueryPool)                                                                         \
    X(vkCmdWriteTimestamp)                                                                         \
    X(vkCreateBuffer)                                                                              \
    X(vkCreateCommandPool)                                                                         \
    X(vkCreateFence)                                                                               \
    X(vkCreateImage)                                                                               \
    X(vkCreateImageView)                                                                           \
    X(vkCreateQueryPool)                                                                           \
    X(vkDestroyBuffer)                                                                             \
    X(vkDestroyCommandPool)                                                                        \
    X(vkDestroyFence)                                                                              \
    X(vkDestroyImage)                                                                              \
    X(vkDestroyImageView)                                                                          \
    X(vkDestroyQueryPool)                                                                          \
    X(vkDeviceWaitIdle)                                                                            \
    X(vkEndCommandBuffer)                                                                          \
    X(vkFreeMemory)                                                                                \
    X(vkGetBufferMemoryRequirements)                                                               \
    X(vkGetDeviceQueue)                                                                            \
    X(vkGetImageMemoryRequirements)                                                                \
    X(vkGetQueryPoolResults)                                                                       \
    X(vkMapMemory)                                                                                 \
    X(vkQueueSubmit)                                                                               \
    X(vkResetCommandPool)                                                                          \
    X(vkResetFences)                                                                               \
    X(vkWaitForFences)

namespace lobelia::host {

#define X(name) PFN_##name name = nullptr;
struct InstanceFunctions {
    LOBELIA_HOST_INSTANCE_FUNCTIONS(X)
};
struct DeviceFunctions {
    LOBELIA_HOST_DEVICE_FUNCTIONS(X)
};
#undef X

/// The device with its functions; stays where it is while objects made from it live.
struct HostContext {
    Device device;
    DeviceFunctions call;
};

template <class Handle, auto destroy>
using HostObject = vk::Unique<HostContext, Handle, destroy>;
using DeviceMemory = HostObject<VkDeviceMemory, &DeviceFunctions::vkFreeMemory>;

} // namespace lobelia::host
