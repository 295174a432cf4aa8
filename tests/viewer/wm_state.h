#pragma once

#include <string>

namespace lobelia::test {

/// Tells a window that it is minimised, or shown again, as window managers do.
void set_minimised(const std::string& display, const std::string& window, bool minimised);

} // namespace lobelia::test
