#pragma once

#include <functional>

#include "host/exr_part.h"

namespace lobelia::host {

/// A block of scanlines or a tile of the full-size image, known to lie inside the file. `x` and `y`
/// are where its first texel lies, as in the data window.
struct ExrChunk {
    exr_chunk_info_t info;
    std::int64_t x, y;
};

/// Checks that the chunk table is in the file and that every chunk, of every level of a mipmap, is
/// there: whole, not empty, not larger than what it decodes to, and not so small that it could not
/// decode to it.
Outcome<Done> check_exr_chunks(const ExrCore& core, const ExrPart& part);

/// Calls `visit` for each chunk of the full-size image, with the same checks, until one fails.
Outcome<Done> for_each_exr_chunk(const ExrCore& core, const ExrPart& part,
                                 const std::function<Outcome<Done>(const ExrChunk&)>& visit);

} // namespace lobelia::host
