#pragma once

#include <string>

namespace lobelia::cli {

/// Exit statuses.
constexpr int SUCCEEDED = 0;
constexpr int FAILED = 1;
constexpr int WRONG_USAGE = 2;

/// Writes "lobelia: `message`" to stderr, as one line whatever the message quotes. Any thread may.
void say(const std::string& message);

/// Says why the program fails and gives the status to exit with.
int fail(const std::string& message);

/// Shows a line on the terminal behind stderr that the next message or status takes the place of;
/// empty only clears. Any thread may.
void show_status(const std::string& status);

/// Writes to stdout; fails if it cannot all be written.
int print(const std::string& text);

} // namespace lobelia::cli
