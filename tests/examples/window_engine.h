#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#include <GLFW/glfw3.h>

#include <cstdint>

/// An engine of vulkan.hpp's RAII classes in a window of GLFW's.
namespace window {

constexpr std::uint32_t SIZE = 96; // pixels a side

struct Image {
    vk::raii::Image handle = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::ImageView view = nullptr;
};
struct Buffer {
    vk::raii::Buffer handle = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
};

/// GLFW's own state, and a window of it.
struct Window {
    GLFWwindow* handle = nullptr;
    Window() {
        if (!glfwInit()) throw std::runtime_error("no display");
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
        handle = glfwCreateWindow(SIZE, SIZE, "Lobelia", nullptr, nullptr);
    }
    ~Window() { glfwTerminate(); }
};

struct Engine {
    Window window;
    vk::raii::Context context;
    vk::raii::Instance instance = nullptr;
    vk::raii::PhysicalDevice physical = nullptr;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::CommandPool pool = nullptr;
    vk::raii::SurfaceKHR surface = nullptr;
    vk::raii::SwapchainKHR swapchain = nullptr;
    vk::raii::Semaphore acquired = nullptr, drawn = nullptr;

    Engine() {
        const vk::ApplicationInfo application{.apiVersion = VK_API_VERSION_1_3};
        std::uint32_t count = 0;
        const char** const extensions = glfwGetRequiredInstanceExtensions(&count);
        instance = {context, vk::InstanceCreateInfo{.pApplicationInfo = &application,
                                                    .enabledExtensionCount = count,
                                                    .ppEnabledExtensionNames = extensions}};
        physical = std::move(instance.enumeratePhysicalDevices().front());
        const float priority = 1;
        const vk::DeviceQueueCreateInfo queues{.queueCount = 1, .pQueuePriorities = &priority};
        const char* const swapchains = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
        const vk::PhysicalDeviceVulkan13Features features{.dynamicRendering = true};
        device = {physical, vk::DeviceCreateInfo{.pNext = &features,
                                                 .queueCreateInfoCount = 1,
                                                 .pQueueCreateInfos = &queues,
                                                 .enabledExtensionCount = 1,
                                                 .ppEnabledExtensionNames = &swapchains}};
        queue = device.getQueue(0, 0);
        pool = {device, vk::CommandPoolCreateInfo{}};
        VkSurfaceKHR made = VK_NULL_HANDLE;
        if (glfwCreateWindowSurface(*instance, window.handle, nullptr, &made) != VK_SUCCESS)
            throw std::runtime_error("no surface");
        surface = {instance, made};
        const auto formats = physical.getSurfaceFormatsKHR(*surface);
        const auto limits = physical.getSurfaceCapabilitiesKHR(*surface);
        swapchain = {device,
                     vk::SwapchainCreateInfoKHR{.surface = *surface,
                                                .minImageCount = limits.minImageCount,
                                                .imageFormat = formats[0].format,
                                                .imageColorSpace = formats[0].colorSpace,
                                                .imageExtent = {SIZE, SIZE},
                                                .imageArrayLayers = 1,
                                                .imageUsage = vk::ImageUsageFlagBits::eTransferDst,
                                                .preTransform = limits.currentTransform,
                                                .clipped = true}};
        acquired = {device, vk::SemaphoreCreateInfo{}};
        drawn = {device, vk::SemaphoreCreateInfo{}};
    }

    vk::raii::DeviceMemory allocate(const vk::MemoryRequirements& needed,
                                    vk::MemoryPropertyFlags kind) const {
        const auto memory = physical.getMemoryProperties();
        std::uint32_t type = 0;
        while (!(needed.memoryTypeBits >> type & 1) ||
               (memory.memoryTypes[type].propertyFlags & kind) != kind)
            if (++type == memory.memoryTypeCount) throw std::runtime_error("no such memory");
        return {device,
                vk::MemoryAllocateInfo{.allocationSize = needed.size, .memoryTypeIndex = type}};
    }

    using Usage = vk::ImageUsageFlagBits;
    Image image(vk::Format format, vk::Extent2D extent, std::uint32_t layers,
                vk::ImageViewType type,
                vk::ImageUsageFlags usage = Usage::eSampled | Usage::eStorage) const {
        const bool cube = type == vk::ImageViewType::eCube;
        Image image;
        image.handle = {device,
                        vk::ImageCreateInfo{.flags = cube ? vk::ImageCreateFlagBits::eCubeCompatible
                                                          : vk::ImageCreateFlags{},
                                            .imageType = vk::ImageType::e2D,
                                            .format = format,
                                            .extent = {extent.width, extent.height, 1},
                                            .mipLevels = 1,
                                            .arrayLayers = layers,
                                            .usage = usage}};
        image.memory = allocate(image.handle.getMemoryRequirements(),
                                vk::MemoryPropertyFlagBits::eDeviceLocal);
        image.handle.bindMemory(*image.memory, 0);
        image.view = {device,
                      vk::ImageViewCreateInfo{
                          .image = *image.handle,
                          .viewType = type,
                          .format = format,
                          .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, layers}}};
        return image;
    }

    Buffer buffer(vk::DeviceSize size, vk::BufferUsageFlags usage) const {
        Buffer buffer;
        buffer.handle = {device, vk::BufferCreateInfo{.size = size, .usage = usage}};
        buffer.memory = allocate(buffer.handle.getMemoryRequirements(),
                                 vk::MemoryPropertyFlagBits::eHostVisible |
                                     vk::MemoryPropertyFlagBits::eHostCoherent);
        buffer.handle.bindMemory(*buffer.memory, 0);
        return buffer;
    }
};

} // namespace window
