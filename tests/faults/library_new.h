#pragma once

#include <cstddef>

namespace lobelia::test {

/// The program's operator new as far as the library calls it on one thread: what the driver and the
/// shim allocate does not count.
struct LibraryNew {
    /// From here on this thread's allocations are counted, and number `failing` fails.
    static void begin(std::size_t failing = std::size_t(-1));
    /// No longer; how many there were.
    static std::size_t end();
    /// Of all that were counted, those that are alive.
    static std::ptrdiff_t live();
};

} // namespace lobelia::test
