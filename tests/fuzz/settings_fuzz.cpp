#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "numbers.h"

// Numbers of any text: refused with a message, or finite, and read again as themselves. What a
// message quotes is made fit for a terminal where it is said.
using namespace lobelia::cli;

namespace {

/// Whether it was read; if not, a message says why.
template <class T>
bool is_read(const Outcome<T>& parsed) {
    if (parsed) return true;
    if (parsed.error().message.empty()) std::abort();
    return false;
}

void check(float number) {
    if (!std::isfinite(number)) std::abort();
    const auto again = parse_number(number_text(number));
    if (!again || *again != number) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const auto number = parse_number(text), exponent = parse_exponent(text);
    if (is_read(number)) check(*number);
    if (is_read(exponent)) check(*exponent);
    const auto exponents = parse_exponents(text);
    if (is_read(exponents))
        for (const float each : *exponents) check(each);
    const auto colour = parse_colour(text), vector = parse_vector(text);
    if (is_read(colour))
        for (const float channel : *colour) check(channel);
    if (is_read(vector))
        for (const float part : *vector) check(part);
    is_read(parse_count(text));
    is_read(parse_size(text));
    return 0;
}
