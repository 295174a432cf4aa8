#pragma once

#include <string>

#include "stage.h"

namespace lobelia::cli {

/// The linear radiance of what is seen, both methods where there are two.
host::Outcome<host::Image> seen_radiance(Stage& stage, const ViewState& state);

/// What is seen as the window shows it, without the panel: sRGB values from 0 to 1.
host::Outcome<host::Image> seen_colours(host::Gpu& gpu, Stage& stage, const ViewState& state,
                                        VkExtent2D extent);

/// A name for a new file in the current folder: lobelia-<date>-<time>[-<number>]`ending`.
std::string new_file_name(const std::string& ending);

} // namespace lobelia::cli
