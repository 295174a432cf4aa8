#include "panorama_fixture.h"

#include "support/panorama_overlap.h"
#include "support/parallel.h"

// What each texel holds, and where.
namespace lobelia::test {
namespace {

// Where a row's edge is tangent to a line of the panorama's grid the midpoint rule converges as
// lines^-1.5 only, with a factor below 3 seen here.
constexpr int LINES = 1000;
const double LINES_ERROR = 3 * std::pow(LINES, -1.5);

TEST_F(PanoramaTest, IntegratesThePanoramaOverEachTexel) {
    const struct {
        Size panorama;
        std::uint32_t face;
    } cases[] = {{{3, 2}, 1}, {{3, 2}, 8}, {{17, 9}, 3}, {{17, 9}, 8}, {{8, 64}, 5}, {{64, 32}, 7}};
    for (const auto& [size, face] : cases) {
        const Image panorama = noise(size, 3 + face);
        const Range light = range(panorama);
        const oracle::Source source = source_of(panorama);
        const Image cube = resample(panorama, face);
        std::vector<double> errors(cube.texels.size() / 4);
        const int n = int(face);
        oracle::parallel_for(errors.size(), [&](std::size_t i) {
            const oracle::Rgb exact = average_over_cube_texel(source, int(i) / (n * n), int(i) % n,
                                                              int(i) / n % n, n, LINES);
            for (std::size_t c = 0; c < 3; ++c)
                errors[i] =
                    std::max(errors[i], std::abs(double(cube.texels[4 * i + c]) - exact[c]) /
                                            double(light.most[c]));
        });
        for (std::size_t i = 0; i < errors.size(); ++i)
            EXPECT_LE(errors[i], LINES_ERROR) << size << " to " << face << " texel " << i;
    }
}

TEST_F(PanoramaTest, ShowsEachColourInItsDirection) {
    const auto colour = [](oracle::Direction d) -> oracle::Rgb {
        const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
        if (x >= y && x >= z) return d.x > 0 ? oracle::Rgb{1, 0, 0} : oracle::Rgb{0, 1, 1};
        if (y >= z) return d.y > 0 ? oracle::Rgb{0, 1, 0} : oracle::Rgb{1, 0, 1};
        return d.z > 0 ? oracle::Rgb{0, 0, 1} : oracle::Rgb{1, 1, 0};
    };
    const Image cube = resample(image_of(oracle::panorama_of(128, 64, colour)), 8);
    const oracle::Direction faces[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                       {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t y = 1; y < 7; ++y)
            for (std::uint32_t x = 1; x < 7; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(double(cube.texel(face, x, y)[c]), colour(faces[face])[c])
                        << "face " << face << " texel " << x << " " << y;
}

TEST_F(PanoramaTest, TurnsTheCubeWithThePanorama) {
    // A quarter about +Y: +Z goes to +X, which is a quarter of the width to the left.
    const Image panorama = noise({64, 32}, 4);
    Image turned = panorama;
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 64; ++x)
            std::copy_n(panorama.texel(0, (x + 16) % 64, y), 4, turned.texel(0, x, y));
    const int size = 17;
    const Image before = resample(panorama, size);
    const Image after = resample(turned, size);
    // The measure's rounding, 2^-23, against a texel's extent of it, 1/80 or more near a pole.
    const double rounding = 80 * 0x1p-23;
    const Range light = range(panorama);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const oracle::Direction d = oracle::cube_direction(face, x + 0.5, y + 0.5, size);
                const oracle::FacePoint to = oracle::cube_point({d.z, d.y, -d.x}, size);
                const float* was =
                    before.texel(std::uint32_t(face), std::uint32_t(x), std::uint32_t(y));
                const float* is =
                    after.texel(std::uint32_t(to.face), std::uint32_t(to.x), std::uint32_t(to.y));
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(double(is[c]), double(was[c]), rounding * double(light.most[c]))
                        << "face " << face << " texel " << x << " " << y;
            }
}

TEST_F(PanoramaTest, GivesTheSameBitsTwice) {
    for (const Size size : {Size{300, 100}, {301, 400}}) {
        const Image panorama = noise(size, 5);
        EXPECT_EQ(resample(panorama, 3).texels, resample(panorama, 3).texels);
    }
}

TEST_F(PanoramaTest, RefusesWhatItCannotDo) {
    // Refused before anything is touched, so any handle will do.
    const host::GpuImage source = on_device(gpu, even_panorama(2, 1, 1, 1, 1));
    const host::GpuImage target =
        value_of(gpu.create_image({.width = 1,
                                   .height = 1,
                                   .layers = 6,
                                   .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                   .cube = true}));
    const auto expect_refused = [&](const Panorama& from, const CubeMap& to, const char* why) {
        const auto job = pass.bind(from, to);
        ASSERT_FALSE(job) << why;
        EXPECT_EQ(job.error().code, VK_ERROR_VALIDATION_FAILED_EXT);
        EXPECT_NE(std::string(job.error().step).find(why), std::string::npos) << job.error().step;
    };
    const Panorama from = panorama_of(source);
    const CubeMap to = cube_of(target);
    for (Size size : {Size{0, 1}, {1, 0}, {32769, 1}, {1, 32769}})
        expect_refused({from.image, from.format, size.width, size.height}, to, "1 to 32768");
    expect_refused(from, {to.image, VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1}, "R32G32B32A32_SFLOAT");
    expect_refused(from, {to.image, to.format, 0, 1}, "a size");
    expect_refused({from.image, from.format, 32768, 16384}, to, "too small");
    EXPECT_TRUE(pass.bind(from, to));
}

} // namespace
} // namespace lobelia::test
