#include "host/message.h"

#include <cerrno>
#include <system_error>

namespace lobelia::host {

namespace {

constexpr std::size_t LONGEST_PATH = 4096;

} // namespace

std::string printable(std::string_view text, std::size_t limit) {
    std::string line(text.substr(0, limit));
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    if (text.size() > limit) line += "...";
    return line;
}

std::string system_message() {
    return std::generic_category().message(errno);
}

Failure about(const std::string& path, const Failure& failure) {
    return {printable(path, LONGEST_PATH) + ": " + failure.message};
}

} // namespace lobelia::host
