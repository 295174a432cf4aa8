#pragma once

#include <array>

#include <vulkan/vulkan_core.h>

#include <lobelia/export.h>
#include <lobelia/result.h>

namespace lobelia {

/// One thing that the library asks of a device. Texts are static.
struct Requirement {
    const char* what = ""; // "cube maps of 1024 texels"
    const char* use = "";  // what works by it
    bool needed = false;   // else it is only useful: what `use` names is all that goes without
    bool met = false;      // by the device asked about
    const char* extension = nullptr; // of the device, to enable for it below Vulkan 1.3
};

/// All of them.
struct Requirements {
    std::array<Requirement, 12> list;

    /// The first that is needed and not met; null where the device will do.
    const Requirement* lacking() const noexcept {
        for (const Requirement& requirement : list)
            if (requirement.needed && !requirement.met) return &requirement;
        return nullptr;
    }
};

/// What a physical device offers of that, before there is a device. No feature of a device has to
/// be enabled. Calls Vulkan through `get_instance_proc_addr` alone; fails where that lacks a
/// function of Vulkan 1.0. From any thread; costs a few calls.
LOBELIA_API Result<Requirements>
requirements(VkInstance instance, VkPhysicalDevice device,
             PFN_vkGetInstanceProcAddr get_instance_proc_addr) noexcept;

} // namespace lobelia
