#pragma once

#include <map>
#include <string>

#include "catalogue.h"

namespace lobelia::hard {

/// What the rows that were run gave, by their ids.
using Run = std::map<std::string, Findings>;

/// The beginning of a row's line on the page: all but what was measured.
std::string promise_line(const Row& row);

/// docs/hard-cases.md after a run: rows that were not run keep what `before`, the page as it was,
/// says of them.
std::string page(const Run& run, const std::string& before);

} // namespace lobelia::hard
