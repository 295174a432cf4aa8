#pragma once

#include <stdexcept>
#include <string>

#include <lobelia/host/gpu.h>
#include <lobelia/image.h>

#include "support/source.h"

namespace lobelia::test {

inline std::string reason(const Error& error) {
    return std::string(error.step) + " (VkResult " + std::to_string(int(error.code)) + ")";
}
inline std::string reason(const host::Failure& failure) {
    return failure.message;
}

/// What a call gave; the test fails with the reason where it gave nothing.
template <class T, class E>
T value_of(Result<T, E> result) {
    if (!result) throw std::runtime_error(reason(result.error()));
    return *std::move(result);
}

/// An environment's texels as the library holds images, and back.
inline host::Image image_of(const oracle::Source& source) {
    return {source.is_cube() ? host::Layout::cube : host::Layout::latlong,
            std::uint32_t(source.width()), std::uint32_t(source.height()),
            std::uint32_t(source.layers()), source.rgba()};
}
inline oracle::Source source_of(const host::Image& image) {
    if (image.layers == 6) return oracle::Source::cube(int(image.width), image.texels);
    return oracle::Source::panorama(int(image.width), int(image.height), image.texels);
}

/// A panorama of one colour.
inline host::Image even_panorama(std::uint32_t width, std::uint32_t height, float red, float green,
                                 float blue) {
    host::Image image{host::Layout::latlong, width, height, 1, {}};
    image.texels.reserve(std::size_t(4) * width * height);
    for (std::size_t i = 0; i < std::size_t(width) * height; ++i)
        image.texels.insert(image.texels.end(), {red, green, blue, 1.0f});
    return image;
}

/// A panorama or cube map on the device, to be sampled.
inline host::GpuImage on_device(host::Gpu& gpu, const host::Image& image) {
    host::GpuImage target = value_of(
        gpu.create_image({.width = image.width,
                          .height = image.height,
                          .layers = image.layers,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          .cube = image.layers == 6}));
    value_of(gpu.upload(image, target));
    return target;
}

/// What the library is lent.
inline Panorama panorama_of(const host::GpuImage& image) {
    const host::GpuImageDescription& shape = image.description();
    return {image.handle(), shape.format, shape.width, shape.height};
}
inline CubeMap cube_of(const host::GpuImage& image) {
    const host::GpuImageDescription& shape = image.description();
    return {image.handle(), shape.format, shape.width, shape.levels};
}

/// A cube map for a pass to fill, which can be read back.
inline host::GpuImage cube_to_fill(host::Gpu& gpu, std::uint32_t size) {
    return value_of(
        gpu.create_image({.width = size,
                          .height = size,
                          .layers = 6,
                          .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                   VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                          .cube = true}));
}

} // namespace lobelia::test
