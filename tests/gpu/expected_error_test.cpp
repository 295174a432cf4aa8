#include <lobelia/expected_error.h>

#include <cmath>

#include <lobelia/scene.h>

#include "measure/checked_panoramas.h"
#include "measure/judged.h"
#include "support/gpu_test.h"
#include "support/oracle.h"
#include "support/real_panoramas.h"

// What is promised is kept on environments that the table was not made from. measure_expected_error
// asks more of them, and more exponents.
namespace lobelia::test {
namespace {

class ExpectedErrorTest : public GpuTest {
protected:
    void expect_maps_kept(Judged& judged, std::span<const float> exponents) {
        for (const Quality quality : QUALITIES) {
            const std::vector<double> found = judged.map_errors(quality, exponents);
            for (std::size_t i = 0; i < exponents.size(); ++i)
                EXPECT_LE(found[i], expected_map_error(quality, exponents[i], judged.face(quality)))
                    << judged.name() << ", quality " << int(quality) << ", n = " << exponents[i];
            EXPECT_LE(found.back(), expected_lambert_error(quality, judged.face(quality)))
                << judged.name();
        }
    }
    /// Each method at the quality that it is the default of.
    void expect_spheres_kept(Judged& judged, std::span<const float> exponents) {
        for (const Quality quality : QUALITIES) {
            const SphereMethod method = host::method_for(quality);
            SCOPED_TRACE(judged.name() + ", quality " + std::to_string(int(quality)));
            const std::uint32_t face = judged.face(quality);
            EXPECT_LE(judged.sphere_error(method, quality, std::nullopt),
                      expected_diffuse_error(method, quality, face));
            for (const float n : exponents)
                EXPECT_LE(judged.sphere_error(method, quality, n),
                          expected_specular_error(method, quality, n, n, face))
                    << "n = " << n;
        }
    }
};

TEST_F(ExpectedErrorTest, IsKeptUnderSyntheticSuns) {
    Judged judged(gpu, "suns over 512 texels", sky_with_suns(512));
    const float exponents[] = {6, 110};
    expect_maps_kept(judged, exponents);
}

TEST_F(ExpectedErrorTest, IsKeptBySpheresUnderSyntheticSuns) {
    Judged judged(gpu, "suns over 256 texels", sky_with_suns(256));
    const float exponents[] = {20};
    expect_spheres_kept(judged, exponents);
}

TEST_F(ExpectedErrorTest, IsKeptOnAPhotograph) {
    if (!has_real_panoramas()) GTEST_SKIP() << "no panoramas in " LOBELIA_PANORAMAS;
    Judged judged(gpu, "courtyard", real_panorama("courtyard"));
    const float exponents[] = {27, 1700};
    expect_maps_kept(judged, exponents);
}

TEST(ExpectedError, OfFinerQualityIsNoLarger) {
    for (const float n : {64.0f, 1000.0f}) {
        EXPECT_LE(expected_map_error(Quality::normal, n, 256),
                  expected_map_error(Quality::fast, n, 256));
        EXPECT_LE(expected_map_error(Quality::high, n, 512),
                  expected_map_error(Quality::normal, n, 256));
    }
}

TEST(ExpectedError, IsInfiniteWhereNothingIsPromised) {
    EXPECT_TRUE(std::isinf(expected_map_error(Quality::high, 2e4f, 512)));
    EXPECT_TRUE(std::isinf(expected_map_error(Quality::normal, 1000, 64))); // sharp as its texels
    EXPECT_TRUE(std::isfinite(expected_map_error(Quality::normal, 100, 64)));
    for (const SphereMethod method : {SphereMethod::kurt2019, SphereMethod::sh2, SphereMethod::sh4,
                                      SphereMethod::importance, SphereMethod::plain_split_sum}) {
        EXPECT_TRUE(std::isinf(expected_diffuse_error(method, Quality::high, 512)));
        EXPECT_TRUE(std::isinf(expected_specular_error(method, Quality::high, 1, 1, 512)));
    }
}

TEST(ExpectedError, OfARangeIsTheLargestInIt) {
    const auto expected = [](float least, float most) {
        return expected_specular_error(SphereMethod::two_tap, Quality::normal, least, most, 256);
    };
    EXPECT_EQ(expected(16, 1024), std::max({expected(16, 16), expected(64, 64), expected(256, 256),
                                            expected(1024, 1024)}));
}

double expected_of(std::span<const SceneMaterial> materials, bool constant = false) {
    return value_of(
               ScenePlan::make({.materials = materials, .constant = constant, .source_size = 256}))
        .expected_error();
}

TEST(ExpectedError, OfASceneIsOfWhatItsMaterialsShow) {
    const std::array<float, 3> grey{0.5f, 0.5f, 0.5f};
    const SceneMaterial dull{.diffuse = grey}, shiny{{}, grey, 16, 16}, both{grey, grey, 16, 16};
    const double diffuse = expected_diffuse_error(SphereMethod::two_tap, Quality::normal, 256);
    const double specular =
        expected_specular_error(SphereMethod::two_tap, Quality::normal, 16, 16, 256);
    EXPECT_EQ(expected_of({}), 0); // the background is seen itself
    EXPECT_EQ(expected_of(std::array{dull}), diffuse);
    EXPECT_EQ(expected_of(std::array{shiny}), specular);
    EXPECT_EQ(expected_of(std::array{both}), std::hypot(diffuse, specular));
    EXPECT_EQ(expected_of(std::array{dull, shiny}), std::max(diffuse, specular));
    EXPECT_EQ(expected_of(std::array{both}, true), EXPECTED_EXACT_ERROR);
}

} // namespace
} // namespace lobelia::test
