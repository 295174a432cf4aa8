#include <lobelia/host/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>

#include <png.h>
#include <zlib.h>

#include "host/guard.h"
#include "host/message.h"
#include "host/tone_map.h"

namespace lobelia::host {

namespace {

// Keeps the arithmetic finite; far above what tone mapping can tell from white.
constexpr float BRIGHTEST = 1e30f;

std::uint8_t byte_of(float value) {
    // A comparison with NaN is false, so NaN is 0.
    return std::uint8_t(value > 0.0f ? std::lround(std::min(value, 1.0f) * 255.0f) : 0);
}

std::array<std::uint8_t, 4> displayed(const float* texel, float scale) {
    const float alpha = texel[3];
    const float unpremultiplied = alpha > 0.0f ? scale / alpha : scale;
    std::array<float, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const float value = texel[c] * unpremultiplied;
        colour[c] = value > 0.0f ? std::min(value, BRIGHTEST) : 0.0f;
    }
    colour = tone_map_neutral(colour);
    return {byte_of(srgb_from_linear(colour[0])), byte_of(srgb_from_linear(colour[1])),
            byte_of(srgb_from_linear(colour[2])), byte_of(alpha)};
}

std::array<std::uint8_t, 4> as_it_is(const float* texel) {
    return {byte_of(texel[0]), byte_of(texel[1]), byte_of(texel[2]), byte_of(texel[3])};
}

// Of each pixel of the picture by `byte_texel`.
template <class ByteTexel>
std::vector<std::uint8_t> bytes_of(const Image& picture, const ByteTexel& byte_texel) {
    const std::size_t texels = std::size_t(picture.width) * picture.height;
    std::vector<std::uint8_t> pixels(texels * 4);
    for (std::size_t i = 0; i < texels; ++i) {
        const std::array<std::uint8_t, 4> pixel = byte_texel(&picture.texels[i * 4]);
        std::copy(pixel.begin(), pixel.end(), &pixels[i * 4]);
    }
    return pixels;
}

// libpng's simplified interface: it reports errors instead of jumping over our destructors.
Outcome<std::vector<std::byte>> encode(const Image& picture,
                                       const std::vector<std::uint8_t>& pixels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = picture.width;
    png.height = picture.height;
    png.format = PNG_FORMAT_RGBA;
    std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
    png_alloc_size_t size = bytes.size();
    const int written =
        png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
    const std::string message = png.message;
    png_image_free(&png);
    if (!written) return Failure{"cannot be encoded as PNG (" + printable(message) + ")"};
    bytes.resize(size);
    return bytes;
}

void append_number(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 0xff);
}

// A chunk of UTF-8 text (PNG specification, 11.3.4.5: iTXt); libpng writes such only by the
// interface that jumps.
std::string text_chunk(const std::string& name, const std::string& text) {
    using namespace std::string_literals;
    const std::string content = "iTXt" + name + "\0\0\0\0\0"s + text;
    std::string chunk;
    append_number(chunk, std::uint32_t(content.size() - 4));
    chunk += content;
    append_number(chunk, std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                             uInt(content.size()))));
    return chunk;
}

// After the signature and the header, whose sizes are fixed.
void insert_metadata(std::vector<std::byte>& png, const Metadata& metadata) {
    constexpr std::ptrdiff_t HEADER_END = 8 + 25;
    std::string chunks;
    for (const auto& [name, text] : metadata) chunks += text_chunk(name, text);
    const auto* const begin = reinterpret_cast<const std::byte*>(chunks.data());
    png.insert(png.begin() + HEADER_END, begin, begin + chunks.size());
}

template <class ByteTexel>
Outcome<Done> write(const std::string& path, const Image& picture, const ByteTexel& byte_texel,
                    const Metadata& metadata) {
    return guarded([&]() -> Outcome<Done> {
        const std::uint64_t floats =
            std::uint64_t(picture.width) * picture.height * std::uint64_t(4);
        if (floats == 0 || picture.texels.size() < floats)
            return about(path, {"cannot be written: the image's texels do not fit its size"});
        try {
            Outcome<std::vector<std::byte>> png = encode(picture, bytes_of(picture, byte_texel));
            if (!png) return about(path, png.error());
            insert_metadata(*png, metadata);
            return replace_file(path, *png);
        } catch (const std::exception& error) {
            return about(path, {"cannot be encoded (" + printable(error.what()) + ")"});
        }
    });
}

} // namespace

Outcome<Done> write_png(const std::string& path, const Image& picture, float exposure) {
    if (!std::isfinite(exposure))
        return about(path, {"cannot be written: the exposure is not a finite number"});
    const float scale = std::exp2(exposure);
    return write(path, picture, [scale](const float* texel) { return displayed(texel, scale); },
                 {});
}

Outcome<Done> write_display_png(const std::string& path, const Image& picture,
                                const Metadata& metadata) {
    for (const auto& [name, text] : metadata)
        if (name.empty() || name.size() > 79)
            return about(path, {"cannot be written: metadata has names of 1 to 79 letters"});
    return write(path, picture, as_it_is, metadata);
}

} // namespace lobelia::host
