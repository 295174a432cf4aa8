#pragma once

#include <string>

#include <lobelia/host/write.h>

#include "view_state.h"

namespace lobelia::cli {

/// The `lobelia render` command that makes the (left) picture in that size, for a shell.
std::string command_line(const ViewState& state, VkExtent2D size);

/// The same settings for a file's metadata.
host::Metadata metadata_of(const ViewState& state, VkExtent2D size);

} // namespace lobelia::cli
