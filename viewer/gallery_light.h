#pragma once

#include <string>
#include <vector>

#include <lobelia/host/work.h>

#include "progress.h"

namespace lobelia::cli {

/// An environment of the gallery.
struct GalleryLight {
    std::string name;
    host::Image large;          // cube map of the size that the panorama needs
    host::Image small;          // of 64 texels a face: what the spheres of figures are lit by
    host::GpuEnvironment light; // the small one on the device
    float exposure = 0.0f;      // stops that bring its mean to a middle grey
};

constexpr std::uint32_t GALLERY_FACE = 64; // of `small`

/// The environments that stand for those of the paper: three photographs where Debian's
/// blender-data has brought them, else the built-in one alone.
host::Outcome<std::vector<GalleryLight>> gallery_lights(host::Gpu& gpu, ProgressLine& progress);

} // namespace lobelia::cli
