#pragma once

#include <string>
#include <string_view>

#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// `text` fit for one line of a message: control characters, which names inside a file and paths
/// may hold, become `?`, and a long text is cut with an ellipsis after `limit` bytes.
std::string printable(std::string_view text, std::size_t limit = 200);

/// What `errno` says, in words.
std::string system_message();

/// `failure` with the file that it is about in front: "<path>: <what is wrong>".
Failure about(const std::string& path, const Failure& failure);

} // namespace lobelia::host
