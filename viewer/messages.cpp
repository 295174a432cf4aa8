#include "messages.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>

namespace lobelia::cli {

namespace {

constexpr const char* CLEAR_LINE = "\r\x1b[K";

std::mutex terminal;
bool has_status = false;

// A file's name may hold anything, also what moves a terminal's cursor.
std::string as_line(const std::string& message) {
    std::string line = "lobelia: " + message;
    for (char& character : line)
        if (static_cast<unsigned char>(character) < ' ' || character == '\x7f') character = '?';
    return line;
}

} // namespace

void say(const std::string& message) {
    const std::string line = as_line(message) + "\n";
    const std::lock_guard lock(terminal);
    if (has_status) std::fputs(CLEAR_LINE, stderr);
    has_status = false;
    std::fwrite(line.data(), 1, line.size(), stderr);
}

int fail(const std::string& message) {
    say(message);
    return FAILED;
}

void show_status(const std::string& status) {
    const std::lock_guard lock(terminal);
    if (has_status) std::fputs(CLEAR_LINE, stderr);
    has_status = !status.empty();
    if (has_status) std::fputs(as_line(status).c_str(), stderr);
}

int print(const std::string& text) {
    show_status("");
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
        return SUCCEEDED;
    return fail(std::string("cannot write to the standard output (") + std::strerror(errno) + ")");
}

} // namespace lobelia::cli
