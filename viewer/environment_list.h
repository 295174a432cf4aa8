#pragma once

#include <string>
#include <vector>

namespace lobelia::cli {

/// Environments that are at hand: "" for the built-in one, the panoramas that Debian's blender-data
/// installs, and those beside `current`.
std::vector<std::string> list_environment_files(const std::string& current);

} // namespace lobelia::cli
