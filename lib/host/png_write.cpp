#include <lobelia/host/write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>

#include <png.h>

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

// libpng's simplified interface: it reports errors instead of jumping over our destructors.
Outcome<std::vector<std::byte>> encode(const Image& picture, float exposure) {
    const float scale = std::exp2(exposure);
    const std::size_t texels = std::size_t(picture.width) * picture.height;
    std::vector<std::uint8_t> pixels(texels * 4);
    for (std::size_t i = 0; i < texels; ++i) {
        const std::array<std::uint8_t, 4> pixel = displayed(&picture.texels[i * 4], scale);
        std::copy(pixel.begin(), pixel.end(), &pixels[i * 4]);
    }

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

} // namespace

Outcome<Done> write_png(const std::string& path, const Image& picture, float exposure) {
    const std::uint64_t floats = std::uint64_t(picture.width) * picture.height * std::uint64_t(4);
    if (floats == 0 || picture.texels.size() < floats)
        return about(path, {"cannot be written: the image's texels do not fit its size"});
    if (!std::isfinite(exposure))
        return about(path, {"cannot be written: the exposure is not a finite number"});
    try {
        const Outcome<std::vector<std::byte>> bytes = encode(picture, exposure);
        if (!bytes) return about(path, bytes.error());
        return replace_file(path, *bytes);
    } catch (const std::exception& error) {
        return about(path, {"cannot be encoded (" + printable(error.what()) + ")"});
    }
}

} // namespace lobelia::host
