#include "host/exr_read.h"

#include <algorithm>

#include "host/cube_layout.h"
#include "host/exr_decode.h"
#include "host/sizes.h"

namespace lobelia::host {

namespace {

// OpenEXR's C++ reader, which has no allocation hook, holds a chunk of DWA in planes, coefficients
// and output at once, and the file around it that we make.
constexpr std::uint64_t CHUNK_COPIES = 6;

Outcome<Done> check_decoder_cost(const ExrPart& part, std::uint64_t budget) {
    if (part.by_core()) return Done{};
    const std::int64_t lines = part.compression == EXR_COMPRESSION_DWAB ? 256 : 32;
    const std::int64_t width =
        part.tiled ? std::min(part.tile_width, part.data.width()) : part.data.width();
    const std::int64_t height = std::min(part.tiled ? part.tile_height : lines, part.data.height());
    if (std::uint64_t(width * height) * part.bytes_per_texel() > budget / CHUNK_COPIES)
        return Failure{"needs more than the limit of " + std::to_string(budget) +
                       " bytes to decode, export it with ZIP"};
    return Done{};
}

Image black_image(const ExrWindow& map) {
    return {Layout::latlong, std::uint32_t(map.width()), std::uint32_t(map.height()), 1,
            std::vector<float>(std::size_t(map.width() * map.height()) * 4)};
}

// Copies what of a chunk lies inside the map.
void paste(std::span<const float> block, const ExrChunk& chunk, const ExrPart& part, Image& image) {
    const std::int64_t begin_x = std::max(chunk.x, part.map.min_x);
    const std::int64_t end_x = std::min(chunk.x + chunk.info.width, part.map.max_x + 1);
    const std::int64_t begin_y = std::max(chunk.y, part.map.min_y);
    const std::int64_t end_y = std::min(chunk.y + chunk.info.height, part.map.max_y + 1);
    const bool grey = part.colour.size() == 1;
    for (std::int64_t y = begin_y; y < end_y; ++y)
        for (std::int64_t x = begin_x; x < end_x; ++x) {
            const float* from =
                &block[std::size_t((y - chunk.y) * chunk.info.width + (x - chunk.x)) * 4];
            float* to = image.texel(0, std::uint32_t(x - part.map.min_x),
                                    std::uint32_t(y - part.map.min_y));
            for (std::size_t c = 0; c < 3; ++c) to[c] = from[grey ? 0 : c];
        }
}

} // namespace

Outcome<Image> read_exr(const InputFile& file, const ReadLimits& limits,
                        std::vector<std::string>& notices) {
    ExrCore core(file, limits);
    const Outcome<Done> opened = core.open();
    if (!opened) return opened.error();
    const Outcome<ExrPart> part = choose_exr_part(core, limits, notices);
    if (!part) return part.error();
    const std::uint64_t budget =
        2 * TEXEL_BYTES * std::uint64_t(part->map.width() * part->map.height()) +
        limits.decoder_bytes;
    const Outcome<Done> affordable = check_decoder_cost(*part, budget);
    if (!affordable) return affordable.error();
    core.allow(budget);
    const Outcome<Done> complete = check_exr_chunks(core, *part);
    if (!complete) return complete.error();

    Image image;
    ExrDecoder decoder(core, *part);
    const Outcome<Done> decoded =
        for_each_exr_chunk(core, *part, [&](const ExrChunk& chunk) -> Outcome<Done> {
            const Outcome<std::span<const float>> block = decoder.decode(chunk);
            if (!block) return block.error();
            // Made only now: a header that lies about the size is mostly found out by its first
            // chunk.
            if (image.texels.empty()) image = black_image(part->map);
            paste(*block, chunk, *part, image);
            return Done{};
        });
    if (!decoded) return decoded.error();
    return part->cube ? cube_from_exr_layout(image) : std::move(image);
}

} // namespace lobelia::host
