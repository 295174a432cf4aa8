#pragma once

#include <string_view>

#include <lobelia/host/outcome.h>
#include <lobelia/prefilter.h>

namespace lobelia::cli {

/// The tier called `fast`, `normal` or `high`.
host::Outcome<Quality> parse_quality(std::string_view text);

/// As on the command line.
const char* quality_name(Quality quality);

} // namespace lobelia::cli
