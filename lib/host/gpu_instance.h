#pragma once

#include <memory>
#include <string>
#include <vector>

#include <lobelia/host/gpu.h>

#include "host/gpu_functions.h"

namespace lobelia::host {

/// A Vulkan instance with its physical devices, and the validation messages that it has collected.
class Instance {
public:
    static Outcome<std::unique_ptr<Instance>> create(const GpuOptions& options);
    Instance() = default;
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;
    ~Instance();

    VkInstance handle = VK_NULL_HANDLE;
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    InstanceFunctions call;
    std::vector<VkPhysicalDevice> physical_devices;
    std::vector<std::string> messages;
    VkSurfaceKHR surface = VK_NULL_HANDLE; // where GpuOptions::presentation asks for one

    /// Whether pictures from this queue can be shown, where there is a surface.
    bool can_present(VkPhysicalDevice device, std::uint32_t queue_family) const;

private:
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    PFN_vkDestroyDebugUtilsMessengerEXT destroy_messenger_ = nullptr;
    Outcome<Done> start(const GpuOptions& options);
    Outcome<Done> listen();
    Outcome<Done> make_surface(const Presentation& presentation);
};

GpuDescription describe(const Instance& instance, VkPhysicalDevice device);

/// A physical device and why it was picked.
struct Choice {
    VkPhysicalDevice device;
    std::string why;
};
/// The device that GpuOptions::device asks for.
Outcome<Choice> choose(const Instance& instance, const std::string& wanted);

/// The failure of a Vulkan call: what could not be done ("create a fence") and what Vulkan
/// answered.
Failure failed(const std::string& step, VkResult code);

} // namespace lobelia::host
