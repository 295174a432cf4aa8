#include "support/png_file.h"

#include <gtest/gtest.h>
#include <png.h>

namespace lobelia::test {

PngFile read_png(const std::string& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&png, path.c_str())) << png.message;
    png.format = PNG_FORMAT_RGBA;
    PngFile file{png.width, png.height, {}};
    file.pixels.resize(std::size_t(png.width) * png.height);
    EXPECT_TRUE(png_image_finish_read(&png, nullptr, file.pixels.data(), 0, nullptr))
        << png.message;
    return file;
}

} // namespace lobelia::test
