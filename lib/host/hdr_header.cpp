#include "host/hdr_header.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "host/message.h"

namespace lobelia::host {

namespace {

constexpr std::size_t LONGEST_LINE = 4096;

// The next line without its end, or nothing at the end of the file or past the longest line.
std::optional<std::string> read_line(ByteReader& bytes) {
    std::string line;
    for (int c = bytes.next(); c >= 0; c = bytes.next()) {
        if (c == '\n') {
            if (!line.empty() && line.back() == '\r') line.pop_back();
            return line;
        }
        if (line.size() == LONGEST_LINE) break;
        line.push_back(char(c));
    }
    return std::nullopt;
}

Failure damaged_header() {
    return {"has a damaged Radiance header (a line has no end or is longer than " +
            std::to_string(LONGEST_LINE) + " bytes), export it again"};
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

Outcome<Done> apply_variable(std::string_view name, std::string_view value, HdrHeader& header,
                             std::vector<std::string>& notices) {
    if (name == "FORMAT" && value == "32-bit_rle_xyze")
        return Failure{"holds XYZ colours (FORMAT=32-bit_rle_xyze), convert it to RGB"};
    if (name == "FORMAT" && value != "32-bit_rle_rgbe")
        return Failure{"has the unknown FORMAT " + printable(value) +
                       ", convert it to 32-bit_rle_rgbe"};
    if (name == "EXPOSURE") {
        double factor = 0.0;
        const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), factor);
        if (code != std::errc() || end != value.data() + value.size() || !std::isnormal(factor) ||
            factor < 0.0)
            return Failure{"has the unusable EXPOSURE " + printable(value) +
                           ", correct or remove that line"};
        header.exposure *= factor;
    }
    if (name == "COLORCORR" || name == "GAMMA" || name == "PRIMARIES")
        notices.push_back("the header's " + std::string(name) + "=" + printable(value) +
                          " is ignored, the values are kept as they are");
    return Done{};
}

struct Axis {
    bool negative;
    bool is_y;
    std::uint32_t length;
};

// Takes "-Y 512" off the front of `text`.
std::optional<Axis> take_axis(std::string_view& text) {
    text = trimmed(text);
    if (text.size() < 3 || (text[0] != '-' && text[0] != '+') || (text[1] != 'X' && text[1] != 'Y'))
        return std::nullopt;
    Axis axis{text[0] == '-', text[1] == 'Y', 0};
    text = trimmed(text.substr(2));
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), axis.length);
    if (code != std::errc()) return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return axis;
}

Outcome<Done> apply_resolution(std::string_view line, const ReadLimits& limits, HdrHeader& header) {
    std::string_view rest = line;
    const std::optional<Axis> slow = take_axis(rest);
    const std::optional<Axis> fast = take_axis(rest);
    if (!slow || !fast || slow->is_y == fast->is_y || !trimmed(rest).empty())
        return Failure{"has the unusable resolution line \"" + printable(line) +
                       "\", export it again"};
    const Axis& x = slow->is_y ? *fast : *slow;
    const Axis& y = slow->is_y ? *slow : *fast;
    header.width = x.length;
    header.height = y.length;
    header.columns = !slow->is_y;
    header.right_to_left = x.negative;
    header.bottom_to_top = !y.negative; // Radiance's Y points up
    if (header.width == 0 || header.height == 0) return Failure{"has no texels, export it again"};
    if (header.width > limits.side || header.height > limits.side ||
        std::uint64_t(header.width) * header.height > limits.texels)
        return Failure{"is " + std::to_string(header.width) + " x " +
                       std::to_string(header.height) + ", above the limit of " +
                       std::to_string(limits.side) + " a side and " +
                       std::to_string(limits.texels) + " texels, reduce it"};
    return Done{};
}

} // namespace

Outcome<HdrHeader> read_hdr_header(ByteReader& bytes, const ReadLimits& limits,
                                   std::vector<std::string>& notices) {
    const std::optional<std::string> magic = read_line(bytes);
    if (!magic || (*magic != "#?RADIANCE" && *magic != "#?RGBE"))
        return Failure{"is neither OpenEXR nor Radiance .hdr, convert it to one of them"};

    HdrHeader header;
    std::uint64_t header_bytes = 0;
    for (;;) {
        const std::optional<std::string> line = read_line(bytes);
        if (!line) return damaged_header();
        if (line->empty()) break;
        header_bytes += line->size() + 1;
        if (header_bytes > limits.attribute_bytes)
            return Failure{"has a header of more than " + std::to_string(limits.attribute_bytes) +
                           " bytes, export it again without its history"};
        const std::size_t equals = line->find('=');
        if (line->front() == '#' || equals == std::string::npos) continue;
        const std::string_view text = *line;
        const Outcome<Done> applied = apply_variable(
            trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)), header, notices);
        if (!applied) return applied.error();
    }
    if (!std::isnormal(header.exposure))
        return Failure{"has EXPOSURE lines whose product is beyond any number, remove them"};

    const std::optional<std::string> resolution = read_line(bytes);
    if (!resolution) return damaged_header();
    const Outcome<Done> applied = apply_resolution(*resolution, limits, header);
    if (!applied) return applied.error();
    return header;
}

} // namespace lobelia::host
