#pragma once

#include <lobelia/host/frames.h>

#include "gallery_light.h"

namespace lobelia::cli {

/// Figure 5 in motion.
struct GalleryAnimation {
    std::string name; // of its file, without ending
    std::string text; // what it shows
    host::Frames times;
};

/// Draws the sphere of figure 5, 512 x 512, in a turning and in a changing environment, each
/// frame's light prefiltered in that frame, and writes the animations into `folder`.
host::Outcome<std::vector<GalleryAnimation>>
gallery_animations(host::Gpu& gpu, const std::vector<GalleryLight>& lights,
                   const std::string& folder, ProgressLine& progress);

} // namespace lobelia::cli
