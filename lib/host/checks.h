#pragma once

#include <array>
#include <optional>

#include <vulkan/vulkan_core.h>

#include <lobelia/host/outcome.h>
#include <lobelia/host/work.h>

namespace lobelia::host {

/// Whether a lobe of this reflectance sends no light.
inline bool is_black(const std::array<float, 3>& colour) {
    return colour == std::array<float, 3>{};
}

/// Why a value is refused, or nothing.
std::optional<Failure> check_exponent(float exponent);

} // namespace lobelia::host
