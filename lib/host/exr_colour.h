#pragma once

#include <string>
#include <vector>

#include "host/exr_part.h"

namespace lobelia::host {

/// Finds the part that holds colour; only its index, channels and colour are filled in.
Outcome<ExrPart> choose_exr_colour(const ExrCore& core, const ReadLimits& limits,
                                   std::vector<std::string>& notices);

} // namespace lobelia::host
