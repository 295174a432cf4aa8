#include <lobelia/host/write.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>

#include <Imath/half.h>
#include <vulkan/vulkan_core.h>

#include "host/guard.h"
#include "host/image_shape.h"
#include "host/message.h"
#include "host/sizes.h"

namespace lobelia::host {

// Khronos 2024, "KTX File Format Specification", version 2.0, and Khronos 2024, "Khronos Data
// Format Specification", version 1.4, for the descriptor.
namespace {

constexpr std::uint64_t HEADER_BYTES = 80; // with the index
constexpr std::uint64_t LEVEL_ENTRY_BYTES = 24;
constexpr std::uint32_t BASIC_BLOCK_BYTES = 24;
constexpr std::uint32_t SAMPLE_BYTES = 16;
constexpr std::uint32_t BLOCK_BYTES = BASIC_BLOCK_BYTES + CHANNELS * SAMPLE_BYTES;
constexpr std::uint32_t DESCRIPTOR_BYTES = 4 + BLOCK_BYTES;
constexpr std::uint32_t KEYS_ALIGNMENT = 4;

constexpr std::uint8_t IDENTIFIER[] = {0xAB, 'K',  'T',  'X',  ' ',  '2',
                                       '0',  0xBB, '\r', '\n', 0x1A, '\n'};

constexpr float LARGEST_HALF = 65504.0f;
constexpr float LEAST_NORMAL_HALF = 0x1p-14f;

struct TexelFormat {
    VkFormat format;
    std::uint32_t channel_bytes;
    std::uint32_t texel_bytes() const { return CHANNELS * channel_bytes; }
};

class LittleEndian {
public:
    template <std::unsigned_integral T>
    void put(T value) {
        for (std::size_t i = 0; i < sizeof value; ++i) bytes_.push_back(std::byte(value >> 8 * i));
    }
    void put_text(const std::string& text) {
        for (const char c : text) put(std::uint8_t(c));
        put(std::uint8_t(0));
    }
    void append(const LittleEndian& more) {
        bytes_.insert(bytes_.end(), more.bytes_.begin(), more.bytes_.end());
    }
    void pad_to(std::uint64_t size) { bytes_.resize(size); }
    void reserve(std::uint64_t size) { bytes_.reserve(size); }
    std::uint64_t size() const { return bytes_.size(); }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

std::uint64_t round_up(std::uint64_t offset, std::uint64_t alignment) {
    return (offset + alignment - 1) / alignment * alignment;
}

Outcome<Done> check_levels(std::span<const Image> levels) {
    if (levels.empty()) return Failure{"cannot be written: there is no image"};
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (const Outcome<Done> fits = check_environment(levels[k]); !fits) return fits.error();
        if (levels[k].layout != Layout::cube)
            return Failure{"cannot be written: KTX2 files hold cube maps, and a level is none"};
        if (k > 0 && levels[k].width != levels[k - 1].width / 2)
            return Failure{"cannot be written: a level is not half as wide as the one before"};
    }
    return Done{};
}

Outcome<Done> check_keys(const Metadata& sorted) {
    constexpr char NUL = '\0';
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const auto& [name, value] = sorted[i];
        const bool is_text = name.find(NUL) == name.npos && value.find(NUL) == value.npos;
        if (name.empty() || !is_text || (i > 0 && name == sorted[i - 1].first))
            return Failure{"cannot be written: \"" + printable(name) +
                           "\" is no key, is there twice, or is not text"};
    }
    return Done{};
}

// Sorted by the bytes of UTF-8, which sorts by code points.
Outcome<Metadata> all_keys(const Metadata& metadata) {
    Metadata keys = metadata;
    for (const auto& [name, value] : metadata)
        if (name.starts_with("KTX") || name.starts_with("ktx"))
            return Failure{"cannot be written: the key \"" + printable(name) +
                           "\" belongs to the format"};
    keys.insert(keys.end(), {{"KTXorientation", "rd"},
                             {"KTXwriter", "lobelia " LOBELIA_VERSION},
                             {"lobelia:sampling", "texel centres"}});
    std::sort(keys.begin(), keys.end());
    if (const Outcome<Done> valid = check_keys(keys); !valid) return valid.error();
    return keys;
}

LittleEndian key_values(const Metadata& keys) {
    LittleEndian bytes;
    for (const auto& [name, value] : keys) {
        bytes.put(std::uint32_t(name.size() + 1 + value.size() + 1));
        bytes.put_text(name);
        bytes.put_text(value);
        bytes.pad_to(round_up(bytes.size(), KEYS_ALIGNMENT));
    }
    return bytes;
}

// Of the colours; alpha is 1. NaN, which either format holds, does not count.
float brightest(std::span<const Image> levels) {
    float brightest = 0.0f;
    for (const Image& level : levels)
        for (std::size_t i = 0; i < level.texels.size(); ++i)
            if (i % CHANNELS != CHANNELS - 1)
                brightest = std::max(brightest, std::abs(level.texels[i]));
    return brightest;
}

// Above the least normal half, what halves lose in the dark is at most 2^-11 of the brightest.
TexelFormat format_for(float brightest) {
    const bool halves =
        brightest == 0.0f || (brightest >= LEAST_NORMAL_HALF && brightest <= LARGEST_HALF);
    if (halves) return {VK_FORMAT_R16G16B16A16_SFLOAT, 2};
    return {VK_FORMAT_R32G32B32A32_SFLOAT, 4};
}

void put_descriptor(LittleEndian& bytes, const TexelFormat& format) {
    constexpr std::uint32_t VERSION = 2;           // 1.3 and 1.4 of the specification
    constexpr std::uint32_t RGBSDA = 1, BT709 = 1; // colour model, primaries
    constexpr std::uint32_t LINEAR = 1;            // transfer function
    constexpr std::uint32_t SIGNED_FLOAT = 0xC0;   // qualifiers of a channel
    constexpr std::uint32_t IDS[] = {0, 1, 2, 15}; // R G B A
    bytes.put(DESCRIPTOR_BYTES);
    bytes.put(0u); // Khronos' basic block
    bytes.put(VERSION | BLOCK_BYTES << 16);
    bytes.put(RGBSDA | BT709 << 8 | LINEAR << 16); // alpha is straight
    bytes.put(0u);                                 // blocks of one texel
    bytes.put(format.texel_bytes());               // in one plane
    bytes.put(0u);
    const std::uint32_t bits = 8 * format.channel_bytes;
    for (std::uint32_t c = 0; c < CHANNELS; ++c) {
        bytes.put(c * bits | (bits - 1) << 16 | (SIGNED_FLOAT | IDS[c]) << 24);
        bytes.put(0u); // at the texel's place
        bytes.put(std::bit_cast<std::uint32_t>(-1.0f));
        bytes.put(std::bit_cast<std::uint32_t>(1.0f));
    }
}

void put_texels(LittleEndian& bytes, const Image& level, const TexelFormat& format) {
    for (std::size_t i = 0; i < level.texels.size(); ++i) {
        const float value = i % CHANNELS == CHANNELS - 1 ? 1.0f : level.texels[i];
        if (format.channel_bytes == 2)
            bytes.put(std::uint16_t(Imath::half(value).bits()));
        else
            bytes.put(std::bit_cast<std::uint32_t>(value));
    }
}

std::uint64_t level_bytes(const Image& level, const TexelFormat& format) {
    return cube_texels(level.width) * format.texel_bytes();
}

// The smallest level comes first in the file; a texel's size is a multiple of 4, so levels begin at
// its multiples.
std::vector<std::uint64_t> level_offsets(std::span<const Image> levels, const TexelFormat& format,
                                         std::uint64_t begin) {
    std::vector<std::uint64_t> offsets(levels.size());
    for (std::size_t k = levels.size(); k-- > 0;) {
        offsets[k] = round_up(begin, format.texel_bytes());
        begin = offsets[k] + level_bytes(levels[k], format);
    }
    return offsets;
}

void put_header(LittleEndian& bytes, const TexelFormat& format, std::uint32_t size,
                std::uint32_t level_count) {
    for (const std::uint8_t byte : IDENTIFIER) bytes.put(byte);
    for (const std::uint32_t field :
         {std::uint32_t(format.format), format.channel_bytes, size, size, 0u /* depth */,
          0u /* no array */, FACES, level_count, 0u /* no supercompression */})
        bytes.put(field);
}

std::vector<std::byte> encode(std::span<const Image> levels, const Metadata& keys) {
    const TexelFormat format = format_for(brightest(levels));
    const LittleEndian key_bytes = key_values(keys);
    const std::uint64_t descriptor = HEADER_BYTES + LEVEL_ENTRY_BYTES * levels.size();
    const std::uint64_t keys_offset = descriptor + DESCRIPTOR_BYTES;
    const auto offsets = level_offsets(levels, format, keys_offset + key_bytes.size());

    LittleEndian file;
    file.reserve(offsets.front() + level_bytes(levels.front(), format));
    put_header(file, format, levels.front().width, std::uint32_t(levels.size()));
    for (const std::uint64_t field :
         {descriptor, std::uint64_t(DESCRIPTOR_BYTES), keys_offset, key_bytes.size()})
        file.put(std::uint32_t(field));
    file.put(std::uint64_t(0)); // no global data of a supercompression
    file.put(std::uint64_t(0));
    for (std::size_t k = 0; k < levels.size(); ++k)
        for (const std::uint64_t field :
             {offsets[k], level_bytes(levels[k], format), level_bytes(levels[k], format)})
            file.put(field);
    put_descriptor(file, format);
    file.append(key_bytes);
    for (std::size_t k = levels.size(); k-- > 0;) {
        file.pad_to(offsets[k]);
        put_texels(file, levels[k], format);
    }
    return file.take();
}

} // namespace

Outcome<Done> write_ktx2(const std::string& path, std::span<const Image> levels,
                         const Metadata& metadata) {
    return guarded([&]() -> Outcome<Done> {
        if (const Outcome<Done> checked = check_levels(levels); !checked)
            return about(path, checked.error());
        const Outcome<Metadata> keys = all_keys(metadata);
        if (!keys) return about(path, keys.error());
        try {
            return replace_file(path, encode(levels, *keys));
        } catch (const std::exception& error) {
            return about(path, {"cannot be encoded (" + printable(error.what()) + ")"});
        }
    });
}

} // namespace lobelia::host
