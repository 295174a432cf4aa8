#pragma once

#include <cstdint>

#include <vulkan/vulkan_core.h>

#include <lobelia/version.h>

namespace lobelia {

/// Told what is worth knowing and no failure. `text` is static.
using WarningCallback = void (*)(const char* text, void* user) noexcept;

/// The caller's Vulkan device, lent. The library calls Vulkan only through `get_device_proc_addr`,
/// links no loader, and never destroys these handles. They must outlive every object made from
/// them.
struct Device {
    VkDevice handle = VK_NULL_HANDLE;
    PFN_vkGetDeviceProcAddr get_device_proc_addr = nullptr;
    VkPipelineCache pipeline_cache = VK_NULL_HANDLE;  // optional
    const VkAllocationCallbacks* allocator = nullptr; // optional
    /// VK_EXT_debug_utils is enabled: pipelines and layouts get names, commands get labels.
    bool debug_utils = false;
    /// Called by create() and bind(), in the thread that calls them.
    WarningCallback on_warning = nullptr;
    void* on_warning_user = nullptr;
    std::uint32_t header_version = HEADER_VERSION; // leave it
};

} // namespace lobelia
