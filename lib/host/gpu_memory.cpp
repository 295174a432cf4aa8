#include "host/gpu_memory.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include <Imath/half.h>

#include "host/sizes.h"

namespace lobelia::host {

namespace {

struct GiveBack {
    VkDeviceSize bytes;
    void operator()(MemoryAccount* account) const { account->taken -= bytes; }
};

/// Memory of the device and its share of the account, which go together.
struct Taken {
    std::unique_ptr<MemoryAccount, GiveBack> share;
    DeviceMemory memory;
};

} // namespace

MemoryAccount open_memory_account(const Instance& instance, VkPhysicalDevice device,
                                  VkDeviceSize most) {
    MemoryAccount account{.together = most ? most : VK_WHOLE_SIZE};
    instance.call.vkGetPhysicalDeviceMemoryProperties(device, &account.types);
    VkPhysicalDeviceMaintenance3Properties of_one{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                           .pNext = &of_one};
    instance.call.vkGetPhysicalDeviceProperties2(device, &properties);
    account.at_once = of_one.maxMemoryAllocationSize;
    return account;
}

struct GpuBuffer::Parts {
    Taken taken; // outlives the buffer bound to it
    HostObject<VkBuffer, &DeviceFunctions::vkDestroyBuffer> buffer;
    VkDeviceSize size = 0;
    std::byte* data = nullptr;
};

GpuBuffer::GpuBuffer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
GpuBuffer::GpuBuffer(GpuBuffer&&) noexcept = default;
GpuBuffer& GpuBuffer::operator=(GpuBuffer&&) noexcept = default;
GpuBuffer::~GpuBuffer() = default;
VkBuffer GpuBuffer::handle() const {
    return parts_->buffer.get();
}
VkDeviceSize GpuBuffer::size() const {
    return parts_->size;
}
std::byte* GpuBuffer::data() const {
    return parts_->data;
}

struct GpuImage::Parts {
    GpuImageDescription description;
    Taken taken;
    HostObject<VkImage, &DeviceFunctions::vkDestroyImage> image;
    HostObject<VkImageView, &DeviceFunctions::vkDestroyImageView> view;
};

GpuImage::GpuImage(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
GpuImage::GpuImage(GpuImage&&) noexcept = default;
GpuImage& GpuImage::operator=(GpuImage&&) noexcept = default;
GpuImage::~GpuImage() = default;
VkImage GpuImage::handle() const {
    return parts_->image.get();
}
VkImageView GpuImage::view() const {
    return parts_->view.get();
}
const GpuImageDescription& GpuImage::description() const {
    return parts_->description;
}

namespace {

std::string bytes_text(VkDeviceSize bytes) {
    return std::to_string(bytes) + " bytes";
}

Outcome<Taken> allocate(const HostContext& context, MemoryAccount& account,
                        const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted) {
    const VkDeviceSize bytes = requirements.size;
    if (bytes > account.together - account.taken)
        return Failure{bytes_text(bytes) + " of device memory are needed and " +
                       bytes_text(account.together - account.taken) + " of the " +
                       std::to_string(account.together) +
                       " that may be taken are left, use a smaller picture or map"};
    const VkPhysicalDeviceMemoryProperties& types = account.types;
    VkDeviceSize granted = 0;
    for (std::uint32_t type = 0; type < types.memoryTypeCount; ++type) {
        const bool allowed = requirements.memoryTypeBits >> type & 1;
        if (!allowed || (types.memoryTypes[type].propertyFlags & wanted) != wanted) continue;
        const VkDeviceSize heap = types.memoryHeaps[types.memoryTypes[type].heapIndex].size;
        granted = std::max(granted, std::min(heap, account.at_once));
        if (bytes > granted) continue;
        const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                        .allocationSize = bytes,
                                        .memoryTypeIndex = type};
        VkDeviceMemory memory = VK_NULL_HANDLE;
        const VkResult code =
            context.call.vkAllocateMemory(context.device.handle, &info, nullptr, &memory);
        if (code != VK_SUCCESS) return failed("allocate " + bytes_text(bytes), code);
        account.taken += bytes;
        return Taken{{&account, {bytes}}, {context, memory}};
    }
    if (granted == 0)
        return Failure{"the device has no memory of the kind needed, pick another device"};
    return Failure{bytes_text(bytes) + " of device memory are needed in one piece and the device " +
                   "gives " + bytes_text(granted) + " at most, use a smaller picture or map"};
}

} // namespace

Outcome<GpuBuffer> make_buffer(const HostContext& context, MemoryAccount& account,
                               VkDeviceSize bytes, VkBufferUsageFlags usage, Memory memory) {
    const VkDevice device = context.device.handle;
    auto parts = std::make_unique<GpuBuffer::Parts>();
    parts->size = bytes;
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                  .size = std::max<VkDeviceSize>(bytes, 1),
                                  .usage = usage};
    VkBuffer handle = VK_NULL_HANDLE;
    VkResult code = context.call.vkCreateBuffer(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return failed("create a buffer", code);
    parts->buffer = {context, handle};

    VkMemoryRequirements requirements;
    context.call.vkGetBufferMemoryRequirements(device, handle, &requirements);
    const bool mapped = memory == Memory::host;
    auto allocated =
        allocate(context, account, requirements,
                 mapped ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                        : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (!allocated) return allocated.error();
    code = context.call.vkBindBufferMemory(device, handle, allocated->memory.get(), 0);
    if (code != VK_SUCCESS) return failed("bind a buffer's memory", code);
    if (mapped) {
        void* data = nullptr;
        code =
            context.call.vkMapMemory(device, allocated->memory.get(), 0, VK_WHOLE_SIZE, 0, &data);
        if (code != VK_SUCCESS) return failed("map a buffer", code);
        parts->data = static_cast<std::byte*>(data);
    }
    parts->taken = std::move(*allocated);
    return GpuBuffer(std::move(parts));
}

Outcome<GpuImage> make_image(const HostContext& context, MemoryAccount& account,
                             const VkPhysicalDeviceLimits& limits,
                             const GpuImageDescription& description) {
    const VkDevice device = context.device.handle;
    const std::uint32_t largest =
        description.cube ? limits.maxImageDimensionCube : limits.maxImageDimension2D;
    if (std::max(description.width, description.height) > largest)
        return Failure{"an image of " + std::to_string(description.width) + " x " +
                       std::to_string(description.height) + " texels is larger than the device's " +
                       std::to_string(largest) + ", use a smaller one"};

    auto parts = std::make_unique<GpuImage::Parts>();
    parts->description = description;
    const VkImageCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .flags = description.cube ? VkImageCreateFlags(VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT) : 0,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = description.format,
        .extent = {description.width, description.height, 1},
        .mipLevels = description.levels,
        .arrayLayers = description.layers,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .usage = description.usage};
    VkImage handle = VK_NULL_HANDLE;
    VkResult code = context.call.vkCreateImage(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return failed("create an image", code);
    parts->image = {context, handle};

    VkMemoryRequirements requirements;
    context.call.vkGetImageMemoryRequirements(device, handle, &requirements);
    auto allocated = allocate(context, account, requirements, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (!allocated) return allocated.error();
    code = context.call.vkBindImageMemory(device, handle, allocated->memory.get(), 0);
    if (code != VK_SUCCESS) return failed("bind an image's memory", code);
    parts->taken = std::move(*allocated);

    const VkImageViewCreateInfo view_info{
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = handle,
        .viewType = description.cube         ? VK_IMAGE_VIEW_TYPE_CUBE
                    : description.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                             : VK_IMAGE_VIEW_TYPE_2D,
        .format = description.format,
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0,
                             VK_REMAINING_ARRAY_LAYERS}};
    VkImageView view = VK_NULL_HANDLE;
    code = context.call.vkCreateImageView(device, &view_info, nullptr, &view);
    if (code != VK_SUCCESS) return failed("create an image view", code);
    parts->view = {context, view};
    return GpuImage(std::move(parts));
}

std::vector<VkBufferImageCopy> rows_of_layers(const GpuImage& image, std::uint32_t first,
                                              std::uint32_t count) {
    const GpuImageDescription& shape = image.description();
    std::vector<VkBufferImageCopy> copies;
    for (std::uint32_t row = first; row < first + count;) {
        const std::uint32_t layer = row / shape.height, y = row % shape.height;
        const std::uint32_t rows = std::min(first + count - row, shape.height - y);
        copies.push_back({.bufferOffset = TEXEL_BYTES * shape.width * (row - first),
                          .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1},
                          .imageOffset = {0, std::int32_t(y), 0},
                          .imageExtent = {shape.width, rows, 1}});
        row += rows;
    }
    return copies;
}

VkBufferImageCopy whole_level(const GpuImage& image, std::uint32_t level) {
    const GpuImageDescription& shape = image.description();
    return {.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, shape.layers},
            .imageExtent = {std::max(shape.width >> level, 1u), std::max(shape.height >> level, 1u),
                            1}};
}

void widen_halves(const std::byte* halves, std::span<float> floats) {
    for (std::size_t i = 0; i < floats.size(); ++i) {
        half value;
        std::memcpy(&value, halves + i * sizeof value, sizeof value);
        floats[i] = value;
    }
}

} // namespace lobelia::host
