#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "numbers.h"

// Numbers of any text: refused with a message of one line, or finite, and read again as themselves.
using namespace lobelia::cli;

namespace {

template <class T>
const T* value_of(const Outcome<T>& parsed) {
    if (parsed) return &*parsed;
    for (const char c : parsed.error().message)
        if (c >= 0 && c < ' ') std::abort();
    if (parsed.error().message.empty()) std::abort();
    return nullptr;
}

void check(float number) {
    if (!std::isfinite(number)) std::abort();
    const auto again = parse_number(number_text(number));
    if (!again || *again != number) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    if (const float* const number = value_of(parse_number(text))) check(*number);
    if (const float* const exponent = value_of(parse_exponent(text))) check(*exponent);
    const auto exponents = parse_exponents(text);
    if (value_of(exponents))
        for (const float exponent : *exponents) check(exponent);
    const auto colour = parse_colour(text);
    if (value_of(colour))
        for (const float channel : *colour) check(channel);
    const auto vector = parse_vector(text);
    if (value_of(vector))
        for (const float part : *vector) check(part);
    value_of(parse_count(text));
    value_of(parse_size(text));
    return 0;
}
