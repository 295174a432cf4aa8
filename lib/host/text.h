#pragma once

#include <array>
#include <string>

namespace lobelia::host {

/// The shortest text that reads back as `value`, whatever the locale.
std::string number_text(float value);
std::string vector_text(const std::array<float, 3>& value); // as "0,0,4"

} // namespace lobelia::host
