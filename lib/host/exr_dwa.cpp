#include "host/exr_dwa.h"

#include <array>
#include <cstring>

namespace lobelia::host {

namespace {

constexpr std::uint64_t BLOCK = 8; // texels on a side of a DCT block

// The numbers that a packed chunk begins with, in OpenEXR's order (ImfDwaCompressor.cpp).
enum Figure : std::size_t {
    VERSION,
    UNKNOWN_BYTES,
    UNKNOWN_PACKED,
    AC_PACKED,
    DC_PACKED,
    RLE_PACKED,
    RLE_BYTES,
    RLE_RAW,
    AC_COUNT,
    DC_COUNT,
    AC_METHOD,
    FIGURES
};

// OpenEXR's reader trusts these more than a stranger's file deserves: they must add up to the
// chunk.
} // namespace

bool is_plausible_dwa(const ExrPart& part, const exr_chunk_info_t& chunk,
                      std::span<const std::byte> packed) {
    std::array<std::uint64_t, FIGURES> figures{};
    if (packed.size() < sizeof figures) return false;
    std::memcpy(figures.data(), packed.data(), sizeof figures);

    std::uint64_t left = packed.size() - sizeof figures;
    for (const Figure section : {UNKNOWN_PACKED, AC_PACKED, DC_PACKED, RLE_PACKED}) {
        if (figures[section] > left) return false;
        left -= figures[section];
    }

    const std::uint64_t texels = std::uint64_t(chunk.width) * std::uint64_t(chunk.height);
    const std::uint64_t blocks = ((std::uint64_t(chunk.width) + BLOCK - 1) / BLOCK) *
                                 ((std::uint64_t(chunk.height) + BLOCK - 1) / BLOCK);
    const std::uint64_t channels = figures[DC_COUNT] / blocks; // one mean a block and channel
    if (figures[VERSION] > 2 || figures[AC_METHOD] > 1 || figures[DC_COUNT] % blocks != 0 ||
        channels > part.channels.size() ||
        figures[AC_COUNT] > blocks * channels * (BLOCK * BLOCK - 1) ||
        figures[UNKNOWN_BYTES] > chunk.unpacked_size || figures[RLE_RAW] > chunk.unpacked_size ||
        figures[RLE_BYTES] > 2 * figures[RLE_RAW])
        return false;
    const std::uint64_t plain = figures[UNKNOWN_BYTES] + figures[RLE_RAW];
    return plain + channels * texels * 2 <= chunk.unpacked_size &&
           chunk.unpacked_size <= plain + channels * texels * 4;
}

} // namespace lobelia::host
