#pragma once

#include <cstddef>

namespace lobelia::test {

/// The program's operator new, which fails when it is told to. Of this thread, and of the library
/// alone: what the driver and the shim allocate does not count.
struct FailingNew {
    /// From here on allocations are counted, and number `failing` fails.
    static void begin(std::size_t failing);
    /// No longer; how many there were.
    static std::size_t end();
};

} // namespace lobelia::test
