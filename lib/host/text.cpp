#include "host/text.h"

#include <charconv>

namespace lobelia::host {

std::string number_text(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return std::string(text, end);
}

std::string vector_text(const std::array<float, 3>& value) {
    return number_text(value[0]) + "," + number_text(value[1]) + "," + number_text(value[2]);
}

} // namespace lobelia::host
