#pragma once

#include "panel.h"
#include "view_state.h"

namespace lobelia::cli {

/// What lies over the pictures: the divider with the methods' names, the legend of the errors, a
/// mark at the picked pixel, and the help.
void draw_overlay(const ViewState& state, const Status& status);

} // namespace lobelia::cli
