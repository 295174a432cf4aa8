#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <lobelia/host/image.h>
#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// One part of an OpenEXR file. `name` may be empty when there is only one part.
struct Part {
    std::string name;
    const Image* image = nullptr;
};

/// Text kept in the file beside the texels, name and value: string attributes in OpenEXR, key/value
/// pairs in KTX.
using Metadata = std::vector<std::pair<std::string, std::string>>;

enum class Content {
    picture,     // channels R G B A, the first layer
    environment, // channels R G B, with the `envmap` attribute; a cube becomes OpenEXR's cube
                 // layout
};

/// Writes 32-bit float OpenEXR, ZIP-compressed; an environment also says `lobelia:sampling` =
/// `texel centres`. Parts may differ in size: each image is its part's data window. The file at
/// `path` stays as it was until the new one is complete, checked by reading it back, and on disk;
/// then it is replaced in one step and keeps its permissions. No file is left behind on failure.
///
/// A symbolic link stays and what it points to is replaced; a device or pipe is written straight
/// into; a folder is refused. The message of a failure begins with `path`.
Outcome<Done> write_exr(const std::string& path, std::span<const Part> parts, Content content,
                        const Metadata& metadata = {});

/// Writes a cube map as KTX 2.0. `levels[k]` is its level k: six faces half as wide as those of
/// level k - 1, rounded down. Linear radiance with the primaries of Rec. 709 and alpha 1, 16-bit
/// float, or 32-bit where 16 would overflow or the brightest value be below its normal range. Also
/// has `KTXorientation`, `KTXwriter` and `lobelia:sampling` = `texel centres`; metadata is refused
/// whose name is there twice or begins with KTX. Replaces `path` in one step, as write_exr does.
Outcome<Done> write_ktx2(const std::string& path, std::span<const Image> levels,
                         const Metadata& metadata = {});

/// Writes an 8-bit sRGB PNG of a picture: scaled by 2^exposure, tone-mapped (Khronos PBR Neutral),
/// alpha as it is (the colour divided by it first where it is not 0, since PNG is not
/// premultiplied). Replaces `path` in one step, as write_exr does.
Outcome<Done> write_png(const std::string& path, const Image& picture, float exposure);

/// Writes an 8-bit sRGB PNG of a picture whose texels are sRGB values from 0 to 1 already; metadata
/// becomes UTF-8 text chunks, names of 1 to 79 ASCII letters. Replaces `path` in one step, as
/// write_exr does.
Outcome<Done> write_display_png(const std::string& path, const Image& picture,
                                const Metadata& metadata = {});

/// Makes `bytes` the content of the file at `path` in one step: they are written to a file beside
/// it (`.lobelia-<process>-<number>.tmp`), brought to the disk and read back, and that file takes
/// the name. On failure the file at `path` is as it was and nothing else is left. A new file has
/// the permissions of any new file, a replaced one keeps its own.
///
/// A symbolic link stays and the file that it points to is replaced. A device or pipe is written
/// straight into. A folder is refused. The message of a failure names `path`.
Outcome<Done> replace_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace lobelia::host
