// An engine, as small as one can be: what it has of Vulkan before Lobelia comes in.
#pragma once

#include <cstdint>

#include <volk.h>

[[noreturn]] void fail(const char* what);
void check(VkResult code, const char* what);

struct Image {
    VkImage handle = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE; // of everything: a cube, or a 2D array, or 2D
    VkDeviceMemory memory = VK_NULL_HANDLE;
};
struct ImageShape {
    VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    std::uint32_t width = 1, height = 1, layers = 1;
    VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;
    VkImageViewType view = VK_IMAGE_VIEW_TYPE_2D;
};
struct Buffer {
    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* data = nullptr; // where the host sees it
};

/// The first device of the system, with one queue for everything.
struct Engine {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    VkCommandPool pool = VK_NULL_HANDLE;

    /// Of Vulkan `version`, with the features that `features` chains, and a queue of the family
    /// that `also` names.
    static Engine create(std::uint32_t version, const void* features = nullptr,
                         std::uint32_t (*also)(const Engine&) = nullptr);
    void destroy();
    void make_pool();

    Image make_image(const ImageShape& shape) const;
    Buffer make_buffer(VkDeviceSize size, VkBufferUsageFlags usage) const;
    void destroy(const Image& image) const;
    void destroy(const Buffer& buffer) const;

    /// A command buffer to record into, and its way to the queue.
    VkCommandBuffer begin() const;
    void submit_and_wait(VkCommandBuffer commands) const;

private:
    VkDeviceMemory allocate(const VkMemoryRequirements& needed, VkMemoryPropertyFlags kind) const;
};

/// A picture of linear R G B A floats to draw on, and its way to a file.
struct Canvas {
    static constexpr VkFormat FORMAT = VK_FORMAT_R32G32B32A32_SFLOAT;
    std::uint32_t width, height;
    Image image;
    Buffer pixels;

    static Canvas create(const Engine& engine, std::uint32_t width, std::uint32_t height);
    /// Dynamic rendering of what is recorded between the two, with viewport and scissor set; what
    /// was drawn before is discarded, depth is cleared to 1.
    void begin(VkCommandBuffer commands, const Image* depth = nullptr) const;
    void end(VkCommandBuffer commands) const;
    /// Copies it from TRANSFER_SRC_OPTIMAL, where end() leaves it, to where the host sees it.
    void read_back(VkCommandBuffer commands) const;
    /// Afterwards: as a portable float map, R G B, each pixel the mean of `samples` x `samples`.
    void write(const char* path, std::uint32_t samples = 1) const;
    void destroy(const Engine& engine) const;
};

/// A transition of the whole of an image, for everything before and after.
void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
                VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT);
