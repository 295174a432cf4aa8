#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

using host::Outcome;

/// Numbers as people write them on a command line: decimal, with a point whatever the locale,
/// finite and within 32 bits; the whole of `text` or a failure that quotes it.
Outcome<float> parse_number(std::string_view text);

/// The exponent of a lobe, and several between commas. A failure also names the range that lobes
/// have; whether a number lies in it is for the library to say.
Outcome<float> parse_exponent(std::string_view text);
Outcome<std::vector<float>> parse_exponents(std::string_view text);

/// A whole number from 0 to 2^32 - 1.
Outcome<std::uint32_t> parse_count(std::string_view text);

/// Numbers between commas, at least one.
Outcome<std::vector<float>> parse_numbers(std::string_view text);

/// `x,y,z`.
Outcome<std::array<float, 3>> parse_vector(std::string_view text);

/// `R,G,B`, or one number for all three.
Outcome<std::array<float, 3>> parse_colour(std::string_view text);

struct Size {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

/// `WxH`, as in 512x512.
Outcome<Size> parse_size(std::string_view text);

/// The shortest text that parse_number reads as `value`.
std::string number_text(float value);

} // namespace lobelia::cli
