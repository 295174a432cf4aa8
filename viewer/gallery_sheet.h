#pragma once

#include <string>
#include <vector>

#include "gallery_figures.h"

namespace lobelia::cli {

/// Writes a figure's pictures into the folder's `pictures`, and one sheet of them all with their
/// captions, which ImageMagick's montage composes, as `folder`/`name`.png.
host::Outcome<Done> write_sheet(const std::string& folder, const GalleryFigure& figure);

/// Puts pictures one after another, `hundredths` of a second each, into `folder`/`name`.gif, by
/// ImageMagick's convert.
host::Outcome<Done> write_animation(const std::string& folder, const std::string& name,
                                    const std::vector<std::string>& pictures, int hundredths);

} // namespace lobelia::cli
