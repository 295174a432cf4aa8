#pragma once

#include <optional>

#include <vulkan/vulkan_core.h>

#include <lobelia/host/outcome.h>
#include <lobelia/sphere.h>

namespace lobelia::host {

/// Why a value is refused, or nothing.
std::optional<Failure> check_exponent(float exponent);
std::optional<Failure> check_view(const SphereView& view, const VkPhysicalDeviceLimits& limits);

} // namespace lobelia::host
