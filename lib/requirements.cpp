#include <lobelia/requirements.h>

#include <cstring>
#include <string_view>
#include <vector>

#include "vk/guard.h"

namespace lobelia {

namespace {

/// The functions of an instance that are asked, and what they say of one device.
class Asked {
public:
    Asked(VkInstance instance, VkPhysicalDevice device, PFN_vkGetInstanceProcAddr find)
        : instance_(instance), device_(device), find_(find) {
        needed<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(device, &about);
    }

    bool has(VkFormat format, VkFormatFeatureFlags image, VkFormatFeatureFlags buffer = 0) const {
        VkFormatProperties found{};
        needed<PFN_vkGetPhysicalDeviceFormatProperties>("vkGetPhysicalDeviceFormatProperties")(
            device_, format, &found);
        return (found.optimalTilingFeatures & image) == image &&
               (found.bufferFeatures & buffer) == buffer;
    }

    bool has_queue(VkQueueFlags flags, std::uint32_t timestamp_bits = 0) const {
        const auto list = needed<PFN_vkGetPhysicalDeviceQueueFamilyProperties>(
            "vkGetPhysicalDeviceQueueFamilyProperties");
        std::uint32_t count = 0;
        list(device_, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        list(device_, &count, families.data());
        for (const VkQueueFamilyProperties& family : families)
            if ((family.queueFlags & flags) == flags && family.timestampValidBits >= timestamp_bits)
                return true;
        return false;
    }

    bool has_dynamic_rendering() const {
        auto ask = optional<PFN_vkGetPhysicalDeviceFeatures2>("vkGetPhysicalDeviceFeatures2");
        if (!ask)
            ask = optional<PFN_vkGetPhysicalDeviceFeatures2>("vkGetPhysicalDeviceFeatures2KHR");
        if (!ask || (about.apiVersion < VK_API_VERSION_1_3 &&
                     !has_extension(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME)))
            return false;
        VkPhysicalDeviceDynamicRenderingFeatures rendering{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES};
        VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                           .pNext = &rendering};
        ask(device_, &features);
        return rendering.dynamicRendering;
    }

    bool has_instance_function(const char* name) const {
        return optional<PFN_vkVoidFunction>(name) != nullptr;
    }

    VkPhysicalDeviceProperties about{};

private:
    VkInstance instance_;
    VkPhysicalDevice device_;
    PFN_vkGetInstanceProcAddr find_;

    template <class Function>
    Function optional(const char* name) const {
        return reinterpret_cast<Function>(find_(instance_, name));
    }

    template <class Function>
    Function needed(const char* name) const {
        const auto found = optional<Function>(name);
        if (!found)
            throw Error{VK_ERROR_INITIALIZATION_FAILED, "load the instance's Vulkan 1.0 functions"};
        return found;
    }

    bool has_extension(std::string_view name) const {
        const auto list = needed<PFN_vkEnumerateDeviceExtensionProperties>(
            "vkEnumerateDeviceExtensionProperties");
        std::uint32_t count = 0;
        vk::check(list(device_, nullptr, &count, nullptr), "list the device's extensions");
        std::vector<VkExtensionProperties> all(count);
        vk::check(list(device_, nullptr, &count, all.data()), "list the device's extensions");
        for (const VkExtensionProperties& extension : all)
            if (name == extension.extensionName) return true;
        return false;
    }
};

constexpr VkFormatFeatureFlags SAMPLED = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
constexpr VkFormatFeatureFlags FILTERED = VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
constexpr VkFormatFeatureFlags STORED = VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;

// Of the largest level of a chain, at any quality (requirements_test.cpp).
constexpr std::uint32_t TEXELS_OF_256 = 1u << 21;
constexpr std::uint32_t TEXELS_OF_1024 = 1u << 25;

} // namespace

Result<Requirements> requirements(VkInstance instance, VkPhysicalDevice device,
                                  PFN_vkGetInstanceProcAddr get_instance_proc_addr) noexcept {
    return vk::guarded<Requirements>([&] {
        if (!instance || !device || !get_instance_proc_addr)
            vk::refuse("requirements() takes an instance, its device and vkGetInstanceProcAddr");
        const Asked asked(instance, device, get_instance_proc_addr);
        const VkPhysicalDeviceLimits& limits = asked.about.limits;
        const VkFormat half = VK_FORMAT_R16G16B16A16_SFLOAT, whole = VK_FORMAT_R32G32B32A32_SFLOAT;
        return Requirements{{{
            {"Vulkan 1.1", "everything", true, asked.about.apiVersion >= VK_API_VERSION_1_1},
            {"a compute queue", "everything but Sphere", true,
             asked.has_queue(VK_QUEUE_COMPUTE_BIT)},
            {"R16G16B16A16_SFLOAT images, sampled, filtered and stored", "prefiltered maps", true,
             asked.has(half, SAMPLED | FILTERED | STORED)},
            {"R32G32B32A32_SFLOAT images, sampled and stored", "environments", true,
             asked.has(whole, SAMPLED | STORED)},
            {"R32G32B32A32_UINT texel buffers", "Prefilter", true,
             asked.has(VK_FORMAT_R32G32B32A32_UINT, 0, VK_FORMAT_FEATURE_UNIFORM_TEXEL_BUFFER_BIT)},
            {"texel buffers of 2^21 texels", "Prefilter of cube maps up to 256", true,
             limits.maxTexelBufferElements >= TEXELS_OF_256},
            {"texel buffers of 2^25 texels and storage buffers of 2^29 bytes",
             "Prefilter of cube maps up to 1024", false,
             limits.maxTexelBufferElements >= TEXELS_OF_1024 &&
                 limits.maxStorageBufferRange >= TEXELS_OF_1024 * 16},
            {"a queue for graphics", "Sphere", false, asked.has_queue(VK_QUEUE_GRAPHICS_BIT)},
            {"R32G32B32A32_SFLOAT images, filtered",
             "Mips in 32 bits and Sphere's background without halves", false,
             asked.has(whole, FILTERED)},
            {"dynamic rendering", "Sphere without a VkRenderPass", false,
             asked.has_dynamic_rendering(), VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME},
            {"timestamps on a compute queue", "PassTimestamps", false,
             asked.has_queue(VK_QUEUE_COMPUTE_BIT, 1)},
            {"VK_EXT_debug_utils enabled on the instance", "names and labels", false,
             asked.has_instance_function("vkSetDebugUtilsObjectNameEXT")},
        }}};
    });
}

} // namespace lobelia
