#pragma once

#include <string>

#include <vulkan/vulkan_core.h>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

/// The failure of a Vulkan call: what could not be done ("create a fence") and what Vulkan said.
inline host::Failure vulkan_failure(const std::string& step, VkResult code) {
    if (code == VK_ERROR_DEVICE_LOST) return {"the device was lost (could not " + step + ")"};
    return {"Vulkan could not " + step + " (VkResult " + std::to_string(int(code)) + ")"};
}

/// The failure of a call of the core library.
inline host::Failure core_failure(const Error& error) {
    if (error.code == VK_ERROR_VALIDATION_FAILED_EXT) return {error.step};
    return vulkan_failure(error.step, error.code);
}

} // namespace lobelia::cli
