#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <lobelia/device.h>
#include <lobelia/host/image.h>
#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// A Vulkan device as `lobelia devices` lists it.
struct GpuDescription {
    std::string name;
    std::string driver; // name and version
    std::string type;   // discrete, integrated, virtual, cpu or other
    std::uint32_t api_version = 0;
};

/// What a Gpu needs to show pictures in a window.
struct Presentation {
    std::vector<const char*> instance_extensions; // that the window's surface comes from
    std::function<VkResult(VkInstance, VkSurfaceKHR*)> make_surface; // the Gpu owns it then
};

struct GpuOptions {
    /// Index in list_gpus() or part of the name; empty picks the first discrete, then integrated,
    /// virtual, CPU device.
    std::string device;
    /// Load the Khronos validation layer (core and synchronisation) and keep its messages.
    bool validation = false;
    /// Where every Vulkan function comes from; null means the system's loader.
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    /// The most memory that the buffers and images of the Gpu may take at a time; 0: what the
    /// device grants. What would take more is refused before anything is allocated.
    VkDeviceSize memory_bytes = 0;
    /// Enables VK_KHR_swapchain and takes a queue that can present to the surface.
    std::optional<Presentation> presentation;
};

/// The devices in the order of their indices; fails when there is no Vulkan driver.
Outcome<std::vector<GpuDescription>> list_gpus(const GpuOptions& options = {});

/// Where a buffer's memory lies.
enum class Memory {
    device, // fastest for the device
    host,   // mapped and coherent: `data` points to it
};

/// A buffer with its own memory. Must not outlive its Gpu.
class GpuBuffer {
public:
    struct Parts;
    explicit GpuBuffer(std::unique_ptr<Parts> parts);
    GpuBuffer(GpuBuffer&&) noexcept;
    GpuBuffer& operator=(GpuBuffer&&) noexcept;
    ~GpuBuffer();

    VkBuffer handle() const;
    VkDeviceSize size() const; // bytes, as asked for
    std::byte* data() const;   // null for Memory::device

private:
    std::unique_ptr<Parts> parts_;
};

/// What an image is: `layers` images of `width` x `height` texels with `levels` mip levels.
struct GpuImageDescription {
    VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t layers = 1;
    std::uint32_t levels = 1;
    VkImageUsageFlags usage = 0;
    bool cube = false; // six layers that a samplerCube can read
};

/// An image with its own memory, and a view of the whole of it (cube, or 2D array). Must not
/// outlive its Gpu.
class GpuImage {
public:
    struct Parts;
    explicit GpuImage(std::unique_ptr<Parts> parts);
    GpuImage(GpuImage&&) noexcept;
    GpuImage& operator=(GpuImage&&) noexcept;
    ~GpuImage();

    VkImage handle() const;
    VkImageView
    view() const; // cube where the description says so, 2D otherwise (2D array if layers > 1)
    const GpuImageDescription& description() const;

private:
    std::unique_ptr<Parts> parts_;
};

/// A Vulkan device of our own with one queue that does graphics and compute. Not thread safe.
class Gpu {
public:
    /// Fails with a message that lists the devices when none fits `options.device`.
    static Outcome<Gpu> create(const GpuOptions& options = {});
    Gpu(Gpu&&) noexcept;
    Gpu& operator=(Gpu&&) noexcept;
    ~Gpu();

    const Device& device() const; // what the core library borrows
    VkInstance instance() const;
    VkPhysicalDevice physical_device() const;
    VkQueue queue() const;
    std::uint32_t queue_family() const;
    VkSurfaceKHR surface() const; // null without GpuOptions::presentation
    PFN_vkGetInstanceProcAddr get_instance_proc_addr() const;
    const GpuDescription& description() const;
    const std::string& why_picked() const;
    const VkPhysicalDeviceLimits& limits() const;

    /// Both fail, and allocate nothing, where the device's memory or GpuOptions::memory_bytes is
    /// too small for them.
    Outcome<GpuBuffer> create_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, Memory memory);
    Outcome<GpuImage> create_image(const GpuImageDescription& description);

    /// Records commands, submits them and waits until the device has finished; what they wrote to
    /// mapped memory can be read then. After a loss of the
    /// device all further calls fail and say so; other failures leave the Gpu as good as before.
    Outcome<Done> submit(const std::function<void(VkCommandBuffer)>& record);

    /// The same, and gives the milliseconds between the device's timestamps before and after;
    /// nothing where its queue has none.
    Outcome<std::optional<double>> submit_timed(const std::function<void(VkCommandBuffer)>& record);

    /// Replaces level 0 of `target` (R32G32B32A32_SFLOAT, TRANSFER_DST usage) by `source` of the
    /// same shape. Leaves it in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders.
    Outcome<Done> upload(const Image& source, const GpuImage& target);
    /// The same in parts: rows [first, first + count) of all layers', from row 0 on and each once.
    /// Between two parts the target is in TRANSFER_DST_OPTIMAL.
    Outcome<Done> upload_rows(const Image& source, const GpuImage& target, std::uint32_t first,
                              std::uint32_t count);

    /// Reads one level of `source` (R32G32B32A32_SFLOAT or R16G16B16A16_SFLOAT, TRANSFER_SRC
    /// usage), which is in `layout` and stays in it.
    Outcome<Image> download(const GpuImage& source, VkImageLayout layout, std::uint32_t level = 0);

    /// Validation messages since the last call; always empty without validation.
    std::vector<std::string> take_messages();

private:
    struct State;
    explicit Gpu(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Records a change of layout of all levels and layers of `image`, which waits for everything
/// before it and is seen by everything after it.
void record_layout_change(const Gpu& gpu, VkCommandBuffer commands, const GpuImage& image,
                          VkImageLayout from, VkImageLayout to);

} // namespace lobelia::host
