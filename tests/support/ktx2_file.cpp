#include "support/ktx2_file.h"

#include <bit>
#include <cmath>
#include <stdexcept>

namespace lobelia::test {

namespace {

float float_from_half(unsigned bits) {
    const int exponent = int(bits >> 10 & 31);
    const int mantissa = int(bits & 1023);
    float value = exponent == 0 ? std::ldexp(float(mantissa), -24)
                                : std::ldexp(float(1024 + mantissa), exponent - 25);
    if (exponent == 31) value = mantissa ? NAN : INFINITY;
    return bits >> 15 ? -value : value;
}

} // namespace

Ktx2File::Ktx2File(std::string bytes) : bytes_(std::move(bytes)) {
    identifier = bytes_.substr(0, 12);
    std::uint64_t offset = 12;
    for (std::uint32_t* field :
         {&format, &type_size, &width, &height, &depth, &layers, &faces, &level_count, &compression,
          &descriptor_offset, &descriptor_size, &keys_offset, &keys_size}) {
        *field = std::uint32_t(number(offset, 4));
        offset += 4;
    }
    global_offset = number(offset, 8);
    global_size = number(offset + 8, 8);
    offset += 16;
    for (std::uint32_t k = 0; k < level_count; ++k, offset += 24)
        levels.push_back({number(offset, 8), number(offset + 8, 8), number(offset + 16, 8)});
    for (std::uint32_t i = 0; i < descriptor_size; i += 4)
        descriptor.push_back(std::uint32_t(number(descriptor_offset + i, 4)));
    read_keys();
    read_padding();
}

const std::string& Ktx2File::value_of(const std::string& key) const {
    for (const auto& [name, value] : keys)
        if (name == key) return value;
    throw std::out_of_range("no key " + key);
}

float Ktx2File::channel(std::uint32_t level, std::uint32_t face, std::uint32_t x, std::uint32_t y,
                        std::uint32_t channel) const {
    const std::uint64_t edge = width >> level;
    const std::uint64_t index = ((face * edge + y) * edge + x) * 4 + channel;
    const std::uint64_t bits = number(levels.at(level).offset + index * type_size, type_size);
    return type_size == 2 ? float_from_half(unsigned(bits))
                          : std::bit_cast<float>(std::uint32_t(bits));
}

std::uint64_t Ktx2File::number(std::uint64_t offset, unsigned size) const {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < size; ++i)
        value |= std::uint64_t(std::uint8_t(bytes_.at(offset + i))) << 8 * i;
    return value;
}

void Ktx2File::read_keys() {
    std::uint64_t offset = keys_offset;
    const std::uint64_t end = offset + keys_size;
    while (offset < end) {
        const std::uint64_t size = number(offset, 4);
        const std::string both = bytes_.substr(offset + 4, size);
        const std::size_t name_size = both.find('\0');
        if (both.size() != size || name_size == both.npos)
            throw std::out_of_range("a key without an end");
        keys.emplace_back(both.substr(0, name_size), both.substr(name_size + 1));
        offset += 4 + size;
        while (offset % 4 != 0) padding += bytes_.at(offset++);
    }
    if (offset != end) throw std::out_of_range("keys beyond their end");
}

void Ktx2File::read_padding() {
    std::uint64_t end = keys_offset + keys_size;
    for (std::size_t k = levels.size(); k-- > 0;) {
        padding += bytes_.substr(end, levels[k].offset - end);
        end = levels[k].offset + levels[k].size;
    }
}

} // namespace lobelia::test
