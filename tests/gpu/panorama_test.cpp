#include <lobelia/host/environment_upload.h>

#include "panorama_fixture.h"

#include "support/real_panoramas.h"

// What becomes of the light as a whole.
namespace lobelia::test {
namespace {

TEST_F(PanoramaTest, LeavesAConstantPanoramaAsItIs) {
    for (const Size panorama : SMALL_PANORAMAS)
        for (std::uint32_t size : {1u, 2u, 3u, 8u, 17u, 33u})
            for (const std::array<float, 3>& light :
                 {std::array{0.0f, 1.0f, 0.18f}, {1e-8f, 65504.0f, FLT_MAX}}) {
                const Image cube = resample(
                    even_panorama(panorama.width, panorama.height, light[0], light[1], light[2]),
                    size);
                for (std::size_t i = 0; i < cube.texels.size(); ++i)
                    ASSERT_EQ(cube.texels[i], i % 4 == 3 ? 1.0f : light[i % 4])
                        << panorama << " to " << size << ", float " << i;
            }
}

// Three suns, one a channel, each one texel in the dark: no light is lost or doubled.
void expect_suns_kept(const Image& panorama, const Image& cube, double tolerance) {
    const oracle::Rgb before = mean(panorama);
    const oracle::Rgb after = mean(cube);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(after[c] / before[c], 1, tolerance)
            << panorama.width << " x " << panorama.height << " to " << cube.width << " channel "
            << c;
}

Image three_suns(Size size, const std::array<std::array<std::uint32_t, 2>, 3>& places) {
    Image image = even_panorama(size.width, size.height, 0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c) image.texel(0, places[c][0], places[c][1])[c] = 1e9f;
    return image;
}

constexpr double MEAN_TOLERANCE = 1e-4;

TEST_F(PanoramaTest, KeepsTheLightOfSunsOfOneTexel) {
    oracle::Random random(1);
    for (const Size size : SMALL_PANORAMAS)
        for (std::uint32_t face : {1u, 2u, 3u, 8u, 17u, 64u}) {
            const auto anywhere = [&] {
                return std::array{std::uint32_t(random.below(int(size.width))),
                                  std::uint32_t(random.below(int(size.height)))};
            };
            const auto any_column = [&] { return anywhere()[0]; };
            const auto any_row = [&] { return anywhere()[1]; };
            const Image inside = three_suns(size, {anywhere(), anywhere(), anywhere()});
            const Image rim = three_suns(size, {std::array{any_column(), 0u},
                                                {any_column(), size.height - 1},
                                                {size.width - 1, any_row()}});
            for (const Image& panorama : {inside, rim})
                expect_suns_kept(panorama, resample(panorama, face), MEAN_TOLERANCE);
        }
}

TEST_F(PanoramaTest, KeepsTheLightOfSunsOfOneTexelInLargeMaps) {
    // Where rounding is worst: texels of both maps are small. The seam, the poles, anywhere.
    for (const Size size : {Size{1023, 511}, {1024, 512}})
        for (std::uint32_t face : {1u, 8u, 64u, 255u, 256u, 512u, 1024u}) {
            if (face == 512 && size.width == 1023) continue; // for time
            const Image panorama =
                three_suns(size, {std::array{face % size.width, 0u},
                                  {size.width - 1, size.height / 3},
                                  {(face * 37 + 11) % size.width, size.height - 1 - face % 200}});
            expect_suns_kept(panorama, resample(panorama, face), MEAN_TOLERANCE);
        }
}

TEST_F(PanoramaTest, KeepsTheLightWhereOneTexelCoversAsManyAsAllowed) {
    // The last column and row: what is left out where an invocation's loops end early.
    const struct {
        Size panorama;
        std::uint32_t face;
    } cases[] = {{{16384, 1}, 1}, {{16384, 2}, 1},   {{16384, 7}, 1},   {{1, 16384}, 1},
                 {{300, 396}, 1}, {{1200, 95}, 1},   {{301, 400}, 1},   {{2700, 2700}, 1},
                 {{512, 690}, 3}, {{16384, 13}, 64}, {{16384, 200}, 64}};
    for (const auto& [size, face] : cases) {
        const Image panorama = three_suns(size, {std::array{size.width - 1, 0u},
                                                 {size.width - 1, size.height / 2},
                                                 {size.width / 2, size.height - 1}});
        expect_suns_kept(panorama, resample(panorama, face), MEAN_TOLERANCE);
    }
}

TEST_F(PanoramaTest, GivesTheSameBitsInParts) {
    // Of 100 x 50 texels an invocation makes a texel, of 4000 x 2000 for faces of 2 a workgroup.
    for (const auto& [panorama, size] :
         {std::pair{Size{100, 50}, 9u}, std::pair{Size{4000, 2000}, 2u}}) {
        const Image source = noise(panorama, 8);
        const Image whole = resample(source, size);
        for (const std::uint32_t rows : {1u, 5u, 6u * size})
            EXPECT_EQ(resample(source, size, rows).texels, whole.texels) << panorama << " " << rows;
    }
}

// Whole and in parts, by the host.
TEST_F(PanoramaTest, IsBroughtToTheDeviceInParts) {
    const Image source = noise({2100, 1050}, 3);
    auto upload = value_of(host::EnvironmentUpload::begin(gpu, source, 64));
    int parts = 0;
    for (double before = -1; upload.done() < 1; ++parts) {
        EXPECT_GT(upload.done(), before);
        before = upload.done();
        value_of(upload.go_on());
    }
    EXPECT_EQ(parts, 18); // of 2^18 texels: nine to copy and nine to resample
    const host::GpuEnvironment made = upload.take();
    const auto layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    EXPECT_EQ(value_of(gpu.download(*made.panorama, layout)).texels, source.texels);
    EXPECT_EQ(value_of(gpu.download(made.cube, layout)).texels, resample(source, 64).texels);

    const Image cube = image_of(oracle::random_cube(oracle::Scene::noise, 250, 3));
    upload = value_of(host::EnvironmentUpload::begin(gpu, cube));
    for (parts = 0; upload.done() < 1; ++parts) value_of(upload.go_on());
    EXPECT_EQ(parts, 4); // two to copy, which meet within a face, and two to make it one of 256
    const host::GpuEnvironment odd = upload.take();
    EXPECT_EQ(value_of(gpu.download(odd.cube, layout)).texels, cube.texels);
    const Image resized = value_of(gpu.download(odd.source(), layout));
    EXPECT_EQ(resized.width, 256u);
    const oracle::Rgb before = mean(cube), after = mean(resized);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], 4e-6 * before[c]);
}

TEST_F(PanoramaTest, StaysBetweenTheLeastAndTheMostLight) {
    for (const Size size : SMALL_PANORAMAS)
        for (std::uint32_t face : {1u, 2u, 3u, 8u, 17u, 64u, 255u}) {
            const Image panorama = noise(size, 2 + face);
            const Range before = range(panorama);
            const Range after = range(resample(panorama, face));
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_GE(after.least[c], before.least[c]) << size << " to " << face;
                EXPECT_LE(after.most[c], before.most[c]) << size << " to " << face;
            }
        }
}

class RealPanoramaTest : public PanoramaTest, public testing::WithParamInterface<std::string> {};
INSTANTIATE_TEST_SUITE_P(Panoramas, RealPanoramaTest, testing::ValuesIn(REAL_PANORAMAS),
                         [](const auto& parameter) { return parameter.param; });

TEST_P(RealPanoramaTest, KeepsItsMeanAndItsRange) {
    if (!has_real_panoramas()) GTEST_SKIP() << "no panoramas in " LOBELIA_PANORAMAS;
    const Image panorama = real_panorama(GetParam());
    const Image cube = resample(panorama, panorama.width / 4);
    const oracle::Rgb before = mean(panorama);
    const oracle::Rgb after = mean(cube);
    const Range outer = range(panorama);
    const Range inner = range(cube);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(after[c] / before[c], 1, MEAN_TOLERANCE);
        EXPECT_GE(inner.least[c], outer.least[c]);
        EXPECT_LE(inner.most[c], outer.most[c]);
    }
}

} // namespace
} // namespace lobelia::test
