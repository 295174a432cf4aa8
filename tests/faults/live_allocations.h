#pragma once

#include <cstddef>

namespace lobelia::test {

/// From here on blocks that this thread takes from the program's operator new count as long as they
/// are alive, those of the library alone: not what the driver and the shim take.
void count_allocations();
std::ptrdiff_t live_allocations();

} // namespace lobelia::test
