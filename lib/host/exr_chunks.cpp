#include "host/exr_chunks.h"

#include <algorithm>

namespace lobelia::host {

namespace {

using Visit = std::function<Outcome<Done>(const ExrChunk&)>;

// 16384 x 8192 texels in tiles of 16 x 16 need half of it.
constexpr std::int32_t MOST_CHUNKS = 1 << 20;

// How many bytes one packed byte can stand for. Deflate reaches 1032 and PXR24 drops a quarter
// before it; the others but DWA stay below. DWA keeps 2 deflated bytes of a block of 64 texels.
constexpr std::uint64_t MOST_EXPANSION = 2048;
constexpr std::uint64_t MOST_EXPANSION_DWA = 1 << 18;

Failure damaged(const ExrCore& core, std::int64_t x, std::int64_t y) {
    return {"is truncated or damaged near texel (" + std::to_string(x) + ", " + std::to_string(y) +
            ")" + core.reason() + ", export it again"};
}

// Core checks most of this too; what a decoder relies on is not left to one reader.
bool is_plausible(const ExrCore& core, const ExrPart& part, const exr_chunk_info_t& chunk,
                  std::int64_t width, std::int64_t height) {
    const std::uint64_t expansion = part.dwa() ? MOST_EXPANSION_DWA : MOST_EXPANSION;
    return chunk.width == width && chunk.height == height &&
           chunk.unpacked_size == std::uint64_t(width * height) * part.bytes_per_texel() &&
           chunk.packed_size > 0 && chunk.packed_size <= chunk.unpacked_size &&
           chunk.unpacked_size / expansion <= chunk.packed_size &&
           (part.compression != EXR_COMPRESSION_NONE || chunk.packed_size == chunk.unpacked_size) &&
           chunk.data_offset <= core.file_bytes() &&
           chunk.packed_size <= core.file_bytes() - chunk.data_offset;
}

Outcome<Done> visit_scanlines(const ExrCore& core, const ExrPart& part, const Visit& visit) {
    std::int32_t lines = 0;
    if (exr_get_scanlines_per_chunk(core.context(), part.index, &lines) != EXR_ERR_SUCCESS ||
        lines < 1)
        return damaged(core, part.data.min_x, part.data.min_y);
    for (std::int64_t y = part.data.min_y; y <= part.data.max_y; y += lines) {
        ExrChunk chunk{{}, part.data.min_x, y};
        const std::int64_t height = std::min<std::int64_t>(lines, part.data.max_y - y + 1);
        if (exr_read_scanline_chunk_info(core.context(), part.index, int(y), &chunk.info) !=
                EXR_ERR_SUCCESS ||
            !is_plausible(core, part, chunk.info, part.data.width(), height))
            return damaged(core, chunk.x, chunk.y);
        const Outcome<Done> visited = visit(chunk);
        if (!visited) return visited.error();
    }
    return Done{};
}

Outcome<Done> visit_tiles(const ExrCore& core, const ExrPart& part, int level, const Visit& visit) {
    std::int32_t width = 0;
    std::int32_t height = 0;
    if (exr_get_level_sizes(core.context(), part.index, level, level, &width, &height) !=
        EXR_ERR_SUCCESS)
        return damaged(core, part.data.min_x, part.data.min_y);
    for (std::int64_t y = 0; y < height; y += part.tile_height)
        for (std::int64_t x = 0; x < width; x += part.tile_width) {
            ExrChunk chunk{{}, part.data.min_x + x, part.data.min_y + y};
            if (exr_read_tile_chunk_info(core.context(), part.index, int(x / part.tile_width),
                                         int(y / part.tile_height), level, level,
                                         &chunk.info) != EXR_ERR_SUCCESS ||
                !is_plausible(core, part, chunk.info, std::min(part.tile_width, width - x),
                              std::min(part.tile_height, height - y)))
                return damaged(core, chunk.x, chunk.y);
            const Outcome<Done> visited = visit(chunk);
            if (!visited) return visited.error();
        }
    return Done{};
}

Outcome<Done> visit_all_levels(const ExrCore& core, const ExrPart& part, const Visit& visit) {
    if (!part.tiled) return visit_scanlines(core, part, visit);
    std::uint32_t tile_width = 0;
    std::uint32_t tile_height = 0;
    exr_tile_level_mode_t mode{};
    exr_tile_round_mode_t rounding{};
    std::int32_t levels_x = 0;
    std::int32_t levels_y = 0;
    if (exr_get_tile_descriptor(core.context(), part.index, &tile_width, &tile_height, &mode,
                                &rounding) != EXR_ERR_SUCCESS ||
        exr_get_tile_levels(core.context(), part.index, &levels_x, &levels_y) != EXR_ERR_SUCCESS)
        return damaged(core, part.data.min_x, part.data.min_y);
    // Core 3.1 miscounts where the smaller levels of a ripmap begin, so they go unchecked.
    const int levels = mode == EXR_TILE_RIPMAP_LEVELS ? 1 : std::min(levels_x, levels_y);
    for (int level = 0; level < levels; ++level) {
        const Outcome<Done> visited = visit_tiles(core, part, level, visit);
        if (!visited) return visited.error();
    }
    return Done{};
}

} // namespace

Outcome<Done> check_exr_chunks(const ExrCore& core, const ExrPart& part) {
    std::int32_t count = 0;
    if (exr_get_chunk_count(core.context(), part.index, &count) != EXR_ERR_SUCCESS || count < 1)
        return damaged(core, part.data.min_x, part.data.min_y);
    if (count > MOST_CHUNKS)
        return Failure{"has " + std::to_string(count) + " tiles, above the limit of " +
                       std::to_string(MOST_CHUNKS) + ", export it with larger ones"};
    if (std::uint64_t(count) * sizeof(std::uint64_t) > core.file_bytes())
        return Failure{"is shorter than its own table of contents, export it again"};

    std::uint64_t packed = 0;
    const Outcome<Done> visited = visit_all_levels(core, part, [&](const ExrChunk& chunk) {
        packed += chunk.info.packed_size;
        return Done{};
    });
    if (!visited) return visited.error();
    // Chunks that share bytes would make a small file stand for a large one.
    if (packed > core.file_bytes()) return Failure{"has overlapping chunks, export it again"};
    return Done{};
}

Outcome<Done> for_each_exr_chunk(const ExrCore& core, const ExrPart& part, const Visit& visit) {
    return part.tiled ? visit_tiles(core, part, 0, visit) : visit_scanlines(core, part, visit);
}

} // namespace lobelia::host
