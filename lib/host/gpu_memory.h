#pragma once

#include <span>

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

/// All layers of one level, tightly packed in a buffer.
VkBufferImageCopy whole_level(const GpuImage& image, std::uint32_t level);

void widen_halves(const std::byte* halves, std::span<float> floats);

} // namespace lobelia::host
