#pragma once

#include <span>
#include <vector>

#include <lobelia/host/gpu.h>

#include "host/gpu_functions.h"

namespace lobelia::host {

Outcome<GpuBuffer> make_buffer(const HostContext& context,
                               const VkPhysicalDeviceMemoryProperties& memory_types,
                               VkDeviceSize bytes, VkBufferUsageFlags usage, Memory memory);

Outcome<GpuImage> make_image(const HostContext& context,
                             const VkPhysicalDeviceMemoryProperties& memory_types,
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
