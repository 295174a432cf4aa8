#pragma once

#include <cstdint>

#include <lobelia/export.h>

namespace lobelia {

/// The version of these headers. A change of the patch changes no interface.
constexpr std::uint32_t VERSION_MAJOR = 0;
constexpr std::uint32_t VERSION_MINOR = 1;
constexpr std::uint32_t VERSION_PATCH = 0;
constexpr std::uint32_t HEADER_VERSION =
    VERSION_MAJOR * 1'000'000 + VERSION_MINOR * 1'000 + VERSION_PATCH;

/// The same number of the library that the program runs with. Each create() compares the two, and
/// fails where they differ in more than the patch.
LOBELIA_API std::uint32_t library_version() noexcept;

} // namespace lobelia
