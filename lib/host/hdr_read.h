#pragma once

#include <string>
#include <vector>

#include <lobelia/host/read.h>

#include "host/input_file.h"

namespace lobelia::host {

/// Reads a Radiance picture as a latitude-longitude map, not yet sanitised. Radiance is the stored
/// value, mantissa * 2^(exponent - 136), divided by every EXPOSURE of the header.
Outcome<Image> read_hdr(const InputFile& file, const ReadLimits& limits,
                        std::vector<std::string>& notices);

} // namespace lobelia::host
