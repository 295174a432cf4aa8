#pragma once

#include <cstddef>
#include <span>

#include "host/exr_chunks.h"

namespace lobelia::host {

/// Decodes one chunk with OpenEXR's C++ reader. That reader sees none of the file but `packed`: it
/// is given a file of this one chunk under a header that we write, so its looser checks have
/// nothing to miss. `texels` gets four floats a texel, of which the part's colour channels fill the
/// first one or three.
Outcome<Done> decode_single_chunk(const ExrPart& part, const ExrChunk& chunk,
                                  std::span<const std::byte> packed, std::span<float> texels);

} // namespace lobelia::host
