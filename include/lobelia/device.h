#pragma once

#include <vulkan/vulkan_core.h>

namespace lobelia {

/// The caller's Vulkan device, lent. The library calls Vulkan only through `get_device_proc_addr`,
/// links no loader, and never destroys these handles. They must outlive every object made from
/// them.
struct Device {
    VkDevice handle = VK_NULL_HANDLE;
    PFN_vkGetDeviceProcAddr get_device_proc_addr = nullptr;
    VkPipelineCache pipeline_cache = VK_NULL_HANDLE;  // optional
    const VkAllocationCallbacks* allocator = nullptr; // optional
};

} // namespace lobelia
