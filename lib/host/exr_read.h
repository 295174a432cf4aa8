#pragma once

#include <string>
#include <vector>

#include <lobelia/host/read.h>

#include "host/input_file.h"

namespace lobelia::host {

/// Reads the colour of an OpenEXR file as a latitude-longitude map or a cube map, not yet
/// sanitised: over its data window where the `envmap` attribute says that it is a map, else over
/// its display window, black where there is no data. OpenEXRCore is the gate for every file:
/// header, limits, chunk table and the size of each chunk are checked before anything is decoded.
Outcome<Image> read_exr(const InputFile& file, const ReadLimits& limits,
                        std::vector<std::string>& notices);

} // namespace lobelia::host
