#pragma once

#include <string>

#include "stage.h"

namespace lobelia::cli {

/// Writes what is seen without the panel, with the settings in the file's metadata, to a new file
/// in the current folder, and gives its name. `ending` is .png, as it is seen, or .exr, in linear
/// radiance.
host::Outcome<std::string> save_screenshot(host::Gpu& gpu, Stage& stage, const ViewState& state,
                                           VkExtent2D extent, const std::string& ending);

} // namespace lobelia::cli
