#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lobelia::test {

/// An 8-bit picture, R G B A.
struct PngFile {
    using Pixel = std::array<std::uint8_t, 4>;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Pixel> pixels; // row by row

    const Pixel& at(std::uint32_t x, std::uint32_t y) const {
        return pixels[std::size_t(y) * width + x];
    }
};

/// Reads it with libpng; fails the test where it is none.
PngFile read_png(const std::string& path);

} // namespace lobelia::test
