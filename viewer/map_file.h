#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lobelia/host/write.h>

#include "outputs.h"

namespace lobelia::cli {

/// `exr` or `ktx2`.
host::Outcome<FileKind> parse_map_format(std::string_view text);

/// The file at `path` to write maps to: in `format`, which has to be the one of the path's ending
/// if that is known, and may be left out then.
host::Outcome<OutputFile> map_file(const std::string& path, std::optional<FileKind> format);

/// Writes one map for each exponent: parts of an OpenEXR file, or the levels of a KTX2 cube map.
host::Outcome<Done> write_maps(const OutputFile& file, const std::vector<host::Image>& maps,
                               const std::vector<float>& exponents, const host::Metadata& metadata);

} // namespace lobelia::cli
