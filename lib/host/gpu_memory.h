#pragma once

#include <span>
#include <vector>

#include <lobelia/host/gpu.h>

#include "host/gpu_functions.h"
#include "host/gpu_instance.h"

namespace lobelia::host {

/// The memory of a Gpu's device: what of it there is, may be taken and is taken. Stays where it is
/// while something made from it lives.
struct MemoryAccount {
    VkPhysicalDeviceMemoryProperties types{};
    VkDeviceSize at_once = 0;  // the most in one allocation
    VkDeviceSize together = 0; // the most in all
    VkDeviceSize taken = 0;
};
MemoryAccount open_memory_account(const Instance& instance, VkPhysicalDevice device,
                                  VkDeviceSize most);

Outcome<GpuBuffer> make_buffer(const HostContext& context, MemoryAccount& account,
                               VkDeviceSize bytes, VkBufferUsageFlags usage, Memory memory);

Outcome<GpuImage> make_image(const HostContext& context, MemoryAccount& account,
                             const VkPhysicalDeviceLimits& limits,
                             const GpuImageDescription& description);

/// Rows [first, first + count) of all layers' at level 0, tightly packed in a buffer: a copy for
/// each layer.
std::vector<VkBufferImageCopy> rows_of_layers(const GpuImage& image, std::uint32_t first,
                                              std::uint32_t count);

/// All layers of one level, tightly packed in a buffer.
VkBufferImageCopy whole_level(const GpuImage& image, std::uint32_t level);

void widen_halves(const std::byte* halves, std::span<float> floats);

} // namespace lobelia::host
