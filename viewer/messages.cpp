#include "messages.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace lobelia::cli {

void say(const std::string& message) {
    std::string line = "lobelia: " + message;
    // A file's name may hold anything, also what moves a terminal's cursor.
    for (char& character : line)
        if (static_cast<unsigned char>(character) < ' ' || character == '\x7f') character = '?';
    line += '\n';
    std::fwrite(line.data(), 1, line.size(), stderr);
}

int fail(const std::string& message) {
    say(message);
    return FAILED;
}

int print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
        return SUCCEEDED;
    return fail(std::string("cannot write to the standard output (") + std::strerror(errno) + ")");
}

} // namespace lobelia::cli
