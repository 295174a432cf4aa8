#pragma once

#include <limits>

namespace lobelia::hard {

inline constexpr float INFINITE = std::numeric_limits<float>::infinity();
inline constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

} // namespace lobelia::hard
