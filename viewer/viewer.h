#pragma once

#include "frame_report.h"
#include "gpu_choice.h"
#include "view_state.h"

namespace lobelia::cli {

/// What the viewer begins with.
struct ViewerStart {
    ViewState state;
    VkExtent2D size{1280, 720};
    GpuChoice gpu;
    bool json = false; // a line a frame on stdout
};

/// Shows the window until the person closes it.
host::Outcome<Done> run_viewer(const ViewerStart& start);

} // namespace lobelia::cli
