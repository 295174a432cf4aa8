#include "numbers.h"

#include <charconv>
#include <cmath>

namespace lobelia::cli {

using host::Failure;

namespace {

Failure refused(std::string_view text, const char* why) {
    return Failure{"\"" + std::string(text) + "\" " + why};
}

Failure with_range(const Failure& failure) {
    return Failure{failure.message + ", exponents lie from 0 to 1e6"};
}

template <class T>
std::from_chars_result read_whole(std::string_view text, T& value) {
    std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec == std::errc{} && read.ptr != text.data() + text.size())
        read.ec = std::errc::invalid_argument;
    return read;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (std::size_t end = text.find(separator); end != text.npos; end = text.find(separator)) {
        pieces.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    pieces.push_back(text);
    return pieces;
}

} // namespace

Outcome<float> parse_number(std::string_view text) {
    std::string_view digits = text;
    // from_chars knows no plus sign, people do; "+-1" stays refused.
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    float value = 0.0f;
    const std::from_chars_result read = read_whole(digits, value);
    if (read.ec == std::errc::result_out_of_range)
        return refused(text, "is beyond what a 32-bit number holds");
    if (read.ec != std::errc{}) return refused(text, "is not a number (as 64, 0.5 or 1e3)");
    if (!std::isfinite(value)) return refused(text, "is not a finite number");
    return value;
}

Outcome<std::uint32_t> parse_count(std::string_view text) {
    std::uint32_t value = 0;
    if (read_whole(text, value).ec != std::errc{})
        return refused(text, "is not a whole number from 0 to 4294967295");
    return value;
}

Outcome<std::vector<float>> parse_numbers(std::string_view text) {
    std::vector<float> values;
    for (const std::string_view piece : split(text, ',')) {
        const Outcome<float> value = parse_number(piece);
        if (!value) return value.error();
        values.push_back(*value);
    }
    return values;
}

Outcome<float> parse_exponent(std::string_view text) {
    const Outcome<float> exponent = parse_number(text);
    if (!exponent) return with_range(exponent.error());
    return exponent;
}

Outcome<std::vector<float>> parse_exponents(std::string_view text) {
    Outcome<std::vector<float>> exponents = parse_numbers(text);
    if (!exponents) return with_range(exponents.error());
    return exponents;
}

Outcome<std::array<float, 3>> parse_vector(std::string_view text) {
    const Outcome<std::vector<float>> values = parse_numbers(text);
    if (!values) return values.error();
    if (values->size() != 3) return refused(text, "is not three numbers x,y,z");
    return std::array{(*values)[0], (*values)[1], (*values)[2]};
}

Outcome<std::array<float, 3>> parse_colour(std::string_view text) {
    const Outcome<std::vector<float>> values = parse_numbers(text);
    if (!values) return values.error();
    const float first = values->front();
    if (values->size() == 1) return std::array{first, first, first};
    if (values->size() != 3) return refused(text, "is neither one number nor three R,G,B");
    return std::array{first, (*values)[1], (*values)[2]};
}

Outcome<Size> parse_size(std::string_view text) {
    const std::vector<std::string_view> sides = split(text, 'x');
    if (sides.size() != 2) return refused(text, "is not a size WxH (as 512x512)");
    const Outcome<std::uint32_t> width = parse_count(sides[0]);
    const Outcome<std::uint32_t> height = parse_count(sides[1]);
    if (!width || !height) return refused(text, "is not a size WxH (as 512x512)");
    return Size{*width, *height};
}

std::string number_text(float value) {
    std::array<char, 64> text{};
    const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

} // namespace lobelia::cli
