#include <limits>

#include <png.h>

#include <lobelia/host/write.h>

#include "file_fixtures.h"

namespace lobelia::test {

class PngWriteTest : public FileTest {
protected:
    // The bytes R G B A that a texel becomes.
    std::vector<int> displayed(const std::vector<float>& texel, float exposure = 0) const {
        const host::Image image{host::Layout::latlong, 1, 1, 1, texel};
        const auto written = host::write_png(path("a.png"), image, exposure);
        if (!written) ADD_FAILURE() << written.error().message;
        return read(path("a.png"));
    }
    static std::vector<int> read(const std::string& name) {
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        if (!png_image_begin_read_from_file(&png, name.c_str())) return {};
        EXPECT_EQ(png.format, unsigned(PNG_FORMAT_RGBA));
        std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
        png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr);
        return {bytes.begin(), bytes.end()};
    }
};

TEST_F(PngWriteTest, MapsTonesByTheKhronosCurveAndSrgb) {
    EXPECT_EQ(displayed({0, 0, 0, 1}), (std::vector<int>{0, 0, 0, 255}));
    // 0.18 - 0.04 = 0.14, in sRGB 1.055 * 0.14^(1/2.4) - 0.055 = 0.4100
    EXPECT_EQ(displayed({0.18f, 0.18f, 0.18f, 1}), (std::vector<int>{105, 105, 105, 255}));
    // Peak 0.96: 1 - 0.24^2 / (0.96 + 0.24 - 0.76) = 0.86909, in sRGB 0.9401
    EXPECT_EQ(displayed({1, 1, 1, 1}), (std::vector<int>{240, 240, 240, 255}));
    EXPECT_EQ(displayed({1e9f, 1e9f, 1e9f, 1}), (std::vector<int>{255, 255, 255, 255}));
}

TEST_F(PngWriteTest, ScalesByTheExposure) {
    EXPECT_EQ(displayed({0.09f, 0.09f, 0.09f, 1}, 1), displayed({0.18f, 0.18f, 0.18f, 1}));
    EXPECT_EQ(displayed({1, 1, 1, 1}, 1000), displayed({1e30f, 1e30f, 1e30f, 1}));
}

TEST_F(PngWriteTest, DividesByAlphaSincePngIsNotPremultiplied) {
    std::vector<int> half = displayed({0.09f, 0.09f, 0.09f, 0.5f});
    EXPECT_EQ(half, (std::vector<int>{105, 105, 105, 128}));
    EXPECT_EQ(displayed({0.18f, 0.18f, 0.18f, 0}), (std::vector<int>{105, 105, 105, 0}));
}

TEST_F(PngWriteTest, ShowsBrokenTexelsAsBlackOrWhite) {
    constexpr float NAN_ = std::numeric_limits<float>::quiet_NaN();
    constexpr float INF = std::numeric_limits<float>::infinity();
    EXPECT_EQ(displayed({NAN_, -1, -INF, NAN_}), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(displayed({INF, INF, INF, INF}).at(3), 255);
}

TEST_F(PngWriteTest, RefusesWhatItCannotShow) {
    const host::Image short_image{host::Layout::latlong, 2, 2, 1, {1, 1, 1, 1}};
    EXPECT_FALSE(host::write_png(path("a.png"), short_image, 0));
    const host::Image image{host::Layout::latlong, 1, 1, 1, {1, 1, 1, 1}};
    EXPECT_FALSE(host::write_png(path("a.png"), image, std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(host::write_png(path("no such folder/a.png"), image, 0));
    EXPECT_EQ(files(), 0u);
}

} // namespace lobelia::test
