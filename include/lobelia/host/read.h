#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <lobelia/host/image.h>
#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// What a file may cost before it is refused (SECURITY.md). Checked from the header, before any
/// allocation that follows the header's figures. Per call: nothing process-wide is read or set.
struct ReadLimits {
    std::uint64_t file_bytes = std::uint64_t(1) << 30;
    std::uint32_t side = 32768;                    // texels of width or height
    std::uint64_t texels = std::uint64_t(1) << 27; // width x height
    std::uint32_t channels = 64;
    std::uint32_t parts = 16;
    std::uint32_t attribute_bytes = 1 << 20;               // all attributes together
    std::uint64_t decoder_bytes = std::uint64_t(64) << 20; // beyond twice the image
};

/// How many texels were not radiance and by what rule they were replaced: NaN and -infinity by 0,
/// +infinity by the channel's largest finite value (0 if it has none), negative values by 0. A
/// texel counts once, in the first class that one of its channels falls into; -infinity is
/// infinite.
struct Sanitised {
    std::uint64_t not_a_number = 0;
    std::uint64_t infinite = 0;
    std::uint64_t negative = 0;
};

/// An environment as read: finite, non-negative, alpha 1.
struct Environment {
    Image image;
    Sanitised sanitised;
    std::vector<std::string> notices; // what was odd but accepted, one line each
};

/// Reads an environment map from an OpenEXR or Radiance .hdr file, told apart by content. Latitude-
/// longitude, or a cube map where an OpenEXR file's `envmap` attribute says so. Only regular files,
/// or links to them, are read.
///
/// OpenEXR: the first part with R, G, B or with Y (grey), else the first with R alone; other
/// channels are ignored, subsampled and deep ones refused. With an `envmap` attribute the map is
/// the data window, as OpenEXR defines it, without one it is the display window, black where there
/// is no data. Values are never converted to other primaries. Radiance: any of the eight
/// orientations; values are divided by EXPOSURE.
///
/// Fails with a message of one line that begins with `path`. Nothing is returned when any of the
/// image's own data is missing or damaged; other parts, and the smaller levels of a ripmap, are not
/// looked at. A refusal because of the header costs under 16 MB whatever the header says.
Outcome<Environment> read_environment(const std::string& path, const ReadLimits& limits = {});

} // namespace lobelia::host
