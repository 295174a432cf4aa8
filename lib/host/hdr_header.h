#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lobelia/host/read.h>

#include "host/byte_reader.h"

namespace lobelia::host {

/// What the text at the start of a Radiance picture says.
struct HdrHeader {
    double exposure = 1.0; // all EXPOSURE lines multiplied
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool columns = false;       // a scanline runs along Y, and scanlines follow one another along X
    bool right_to_left = false; // x decreases in file order
    bool bottom_to_top = false; // the file begins with the lowest row
};

/// Reads up to and including the resolution line; `bytes` then stands at the first scanline.
Outcome<HdrHeader> read_hdr_header(ByteReader& bytes, const ReadLimits& limits,
                                   std::vector<std::string>& notices);

} // namespace lobelia::host
