#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <OpenEXR/openexr.h>

#include "host/exr_core.h"

namespace lobelia::host {

/// Where texels lie: corners included, wide enough that widths and differences cannot overflow.
struct ExrWindow {
    std::int64_t min_x = 0, min_y = 0, max_x = -1, max_y = -1;

    std::int64_t width() const { return max_x - min_x + 1; }
    std::int64_t height() const { return max_y - min_y + 1; }
};

struct ExrChannel {
    std::string name;
    exr_pixel_type_t type = EXR_PIXEL_FLOAT;
    bool linear = false; // how lossy compressions treat the channel
};

/// The part of an OpenEXR file that is read, its header checked against the limits.
struct ExrPart {
    int index = 0;
    std::vector<ExrChannel> channels;
    std::vector<std::size_t> colour; // which channels are R, G and B, or the only grey one
    bool tiled = false;
    std::int64_t tile_width = 0, tile_height = 0;
    exr_compression_t compression = EXR_COMPRESSION_NONE;
    bool cube = false;
    ExrWindow data;
    ExrWindow map; // what the image covers: the display window, of an `envmap` the data window

    std::uint64_t bytes_per_texel() const; // decoded, all channels

    bool dwa() const {
        return compression == EXR_COMPRESSION_DWAA || compression == EXR_COMPRESSION_DWAB;
    }
    /// Whether OpenEXRCore decodes the part's compression: 3.1 has no DWAA and DWAB, and puts the
    /// texels of float channels in B44 and B44A in the wrong place without an error.
    bool by_core() const {
        return !dwa() && compression != EXR_COMPRESSION_B44 && compression != EXR_COMPRESSION_B44A;
    }
};

/// Chooses the first part with R, G, B or with Y, else the first with R alone, and adds what is odd
/// about it to `notices`. Fails with the names of what is there instead.
Outcome<ExrPart> choose_exr_part(const ExrCore& core, const ReadLimits& limits,
                                 std::vector<std::string>& notices);

} // namespace lobelia::host
