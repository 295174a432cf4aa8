#pragma once

#include <cstddef>
#include <span>

#include "host/exr_part.h"

namespace lobelia::host {

/// Whether the figures that a DWAA or DWAB chunk begins with add up to its packed and unpacked
/// size. OpenEXR's decoder trusts them more than a stranger's file deserves.
bool is_plausible_dwa(const ExrPart& part, const exr_chunk_info_t& chunk,
                      std::span<const std::byte> packed);

} // namespace lobelia::host
