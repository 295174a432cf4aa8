#include "host/hdr_read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "host/byte_reader.h"
#include "host/hdr_header.h"

namespace lobelia::host {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// Ward 1991, "Real Pixels" (Graphics Gems II); run lengths as in Radiance's color.c.
constexpr std::size_t SHORTEST_RUN_LENGTH_LINE = 8;
constexpr std::size_t LONGEST_RUN_LENGTH_LINE = 32767;

bool read_texel(ByteReader& bytes, Rgbe& texel) {
    for (std::uint8_t& component : texel) {
        const int byte = bytes.next();
        if (byte < 0) return false;
        component = std::uint8_t(byte);
    }
    return true;
}

// One component of a whole line: runs (count above 128, then one value) and literals.
bool read_component(ByteReader& bytes, std::span<Rgbe> line, std::size_t component) {
    for (std::size_t x = 0; x < line.size();) {
        const int code = bytes.next();
        if (code <= 0) return false; // the end, or a run of nothing
        const bool run = code > 128;
        const std::size_t count = std::size_t(run ? code - 128 : code);
        if (count > line.size() - x) return false;
        int value = run ? bytes.next() : 0;
        for (std::size_t end = x + count; x < end; ++x) {
            if (!run) value = bytes.next();
            if (value < 0) return false;
            line[x][component] = std::uint8_t(value);
        }
    }
    return true;
}

// Flat texels, among which 1 1 1 n repeats the one before n times; a repeat right after a repeat
// counts in the next higher byte.
bool read_flat_line(ByteReader& bytes, std::span<Rgbe> line, Rgbe texel) {
    unsigned shift = 0;
    for (std::size_t x = 0;;) {
        if (texel[0] == 1 && texel[1] == 1 && texel[2] == 1) {
            if (x == 0 || shift > 16) return false;
            const std::size_t count = std::size_t(texel[3]) << shift;
            if (count > line.size() - x) return false;
            std::fill_n(line.begin() + std::ptrdiff_t(x), count, line[x - 1]);
            x += count;
            shift += 8;
        } else {
            line[x++] = texel;
            shift = 0;
        }
        if (x == line.size()) return true;
        if (!read_texel(bytes, texel)) return false;
    }
}

bool read_line(ByteReader& bytes, std::span<Rgbe> line) {
    Rgbe first{};
    if (!read_texel(bytes, first)) return false;
    const bool may_run =
        line.size() >= SHORTEST_RUN_LENGTH_LINE && line.size() <= LONGEST_RUN_LENGTH_LINE;
    if (!may_run || first[0] != 2 || first[1] != 2 || first[2] > 127)
        return read_flat_line(bytes, line, first);
    if (std::size_t(first[2]) * 256 + first[3] != line.size()) return false;
    for (std::size_t component = 0; component < 4; ++component)
        if (!read_component(bytes, line, component)) return false;
    return true;
}

// 2^(exponent - 136) / exposure for each exponent; exponent 0 is black whatever the mantissa.
std::array<float, 256> make_scales(double exposure) {
    std::array<float, 256> scales{};
    for (int e = 1; e < 256; ++e)
        scales[std::size_t(e)] = float(std::ldexp(1.0, e - 136) / exposure);
    return scales;
}

// The rows of the picture from the lines of the file. The usual order needs no copy.
std::vector<float> upright(std::vector<float> lines, const HdrHeader& header) {
    if (!header.columns && !header.right_to_left && !header.bottom_to_top) return lines;
    std::vector<float> rows(lines.size());
    for (std::size_t y = 0; y < header.height; ++y) {
        const std::size_t file_y = header.bottom_to_top ? header.height - 1 - y : y;
        for (std::size_t x = 0; x < header.width; ++x) {
            const std::size_t file_x = header.right_to_left ? header.width - 1 - x : x;
            const std::size_t from =
                header.columns ? file_x * header.height + file_y : file_y * header.width + file_x;
            std::copy_n(&lines[from * 4], 4, &rows[(y * header.width + x) * 4]);
        }
    }
    return rows;
}

} // namespace

Outcome<Image> read_hdr(const InputFile& file, const ReadLimits& limits,
                        std::vector<std::string>& notices) {
    ByteReader bytes(file);
    const Outcome<HdrHeader> header = read_hdr_header(bytes, limits, notices);
    if (!header) return header.error();

    const std::size_t line_count = header->columns ? header->width : header->height;
    const std::array<float, 256> scales = make_scales(header->exposure);
    std::vector<Rgbe> line(header->columns ? header->height : header->width);
    // Reserving touches no memory: a short file that claims to be large costs only what it holds.
    std::vector<float> lines;
    lines.reserve(line_count * line.size() * 4);
    for (std::size_t i = 0; i < line_count; ++i) {
        if (!read_line(bytes, line))
            return Failure{"is truncated or damaged in scanline " + std::to_string(i) +
                           ", export it again"};
        for (const Rgbe& texel : line) {
            const float scale = scales[texel[3]];
            lines.insert(lines.end(), {float(texel[0]) * scale, float(texel[1]) * scale,
                                       float(texel[2]) * scale, 1.0f});
        }
    }
    return Image{Layout::latlong, header->width, header->height, 1,
                 upright(std::move(lines), *header)};
}

} // namespace lobelia::host
