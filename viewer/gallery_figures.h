#pragma once

#include "gallery_light.h"

namespace lobelia::cli {

/// A picture of a figure.
struct GalleryCell {
    std::string caption; // beneath it, lines apart
    host::Image picture;
    float exposure = 0.0f;
};

/// A figure: rows of pictures.
struct GalleryFigure {
    std::string name; // of its files, without ending
    std::string title;
    std::string text; // what it shows
    std::size_t columns = 1;
    std::vector<GalleryCell> cells; // row by row
};

/// Figures 1 to 5 of Kurt 2019, "Real-Time Shading with Phong BRDF Model", by the default method,
/// by the paper's own and by the reference, which takes nearly all of the time.
host::Outcome<std::vector<GalleryFigure>>
gallery_figures(host::Gpu& gpu, const std::vector<GalleryLight>& lights, ProgressLine& progress);

} // namespace lobelia::cli
