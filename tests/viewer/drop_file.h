#pragma once

#include <string>

namespace lobelia::test {

/// Drops a file onto a window's middle, as a file manager does. Returns once the window has taken
/// it.
void drop_file(const std::string& display, const std::string& window, const std::string& path);

} // namespace lobelia::test
