#include <cfloat>
#include <cmath>
#include <limits>

#include "prefilter_fixture.h"
#include "support/qualities.h"

namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;
using oracle::Scene;

const std::vector<float> EXPONENTS{0, 0.5f, 1, 4.8f, 16, 45, 64, 700, 2048, 1e4f, 1e6f};

constexpr double HALF = 0x1p-11; // relative error of a half, rounded to the nearest

// Weighted sums of a constant divided by the sum of weights, and the fetches, in 32 bits.
constexpr double SUMS = 1e-5;

// The light is rounded to halves once, on its way in: what comes out is one already. But on a
// source of 16 texels a face the sums of the harmonics, from 1 to 45, leave a ripple that may tip
// it to the half beside it.
double constant_error(float exponent, std::uint32_t source_size) {
    const bool harmonics = exponent >= 1 && exponent < 45;
    return (source_size < 64 && harmonics ? 2 : 1) * HALF + SUMS;
}

std::string label(const Prefiltered& made, std::size_t map) {
    return "n " + std::to_string(made.plan.maps()[map].exponent) + " of " +
           std::to_string(made.plan.maps()[map].size);
}

TEST_F(PrefilterTest, LeavesConstantLightAsItIs) {
    const std::array<float, 3> light{1, 0.18f, 37};
    const Directions axes = oracle::test_directions(500, 1);
    double worst = 0;
    for (const Quality quality : QUALITIES)
        for (std::uint32_t size : {16u, 64u, 256u}) {
            const Prefiltered made =
                make(even_cube(size, light[0], light[1], light[2]), {EXPONENTS, true, quality});
            EXPECT_EQ(made.found().sun_count, 0u);
            for (std::size_t map = 0; map < made.maps.size(); ++map) {
                const double allowed = constant_error(made.plan.maps()[map].exponent, size);
                for (const Average& average : read(made, map, axes))
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double error = std::abs(double(average[c]) / double(light[c]) - 1);
                        ASSERT_LE(error, allowed)
                            << "quality " << int(quality) << " source " << size << " "
                            << label(made, map) << ": " << average[c] << " for " << light[c];
                        worst = std::max(worst, error);
                    }
            }
        }
    RecordProperty("worst", std::to_string(worst));
}

TEST_F(PrefilterTest, MakesNothingOutOfBlack) {
    for (std::uint32_t size : {16u, 32u, 128u}) {
        const Prefiltered made = make(even_cube(size, 0, 0, 0), {EXPONENTS, true});
        EXPECT_EQ(made.found().sun_count, 0u);
        for (std::size_t map = 0; map < made.maps.size(); ++map)
            for (const Average& average : read(made, map, oracle::test_directions(200, 2)))
                for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(average[c], 0) << label(made, map);
    }
}

const float ODD_VALUES[] = {std::numeric_limits<float>::quiet_NaN(),
                            -std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::signaling_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            -1.0f,
                            -0.0f,
                            FLT_MAX,
                            -FLT_MAX,
                            FLT_MIN / 8,
                            1e9f,
                            65520};

class SoundTest : public PrefilterTest {
protected:
    void expect_sound(const host::Image& source, const std::string& what) {
        const Prefiltered made = make(source, {{0, 1, 16, 45, 700, 1e6f}, true});
        for (std::size_t map = 0; map < made.maps.size(); ++map)
            for (const Average& average : read(made, map, texel_directions(16)))
                for (std::size_t c = 0; c < 3; ++c) {
                    ASSERT_TRUE(std::isfinite(average[c])) << what << " " << label(made, map);
                    ASSERT_GE(average[c], 0) << what << " " << label(made, map);
                }
    }
};

TEST_F(SoundTest, StaysFiniteAndPositive) {
    for (std::uint32_t size : {16u, 32u, 64u}) {
        const host::Image noise = image_of(oracle::random_cube(Scene::noise, int(size), 3));
        expect_sound(noise, "noise");
        expect_sound(image_of(oracle::random_cube(Scene::suns, int(size), 4)), "suns");
        for (float odd : ODD_VALUES) {
            host::Image one = noise;
            one.texel(3, size / 2, size / 3)[1] = odd;
            expect_sound(one, "one " + std::to_string(odd));
            expect_sound(even_cube(size, odd, odd, odd), "all " + std::to_string(odd));
        }
    }
}

TEST_F(SoundTest, TakesWhatIsNoLightForBlack) {
    host::Image image = image_of(oracle::random_cube(Scene::noise, 32, 5));
    float& texel = image.texel(1, 7, 31)[2];
    texel = 0;
    const Wanted wanted{{0.5f, 4.8f, 64, 1e4f}, true};
    const Prefiltered black = make(image, wanted);
    for (float odd : ODD_VALUES) {
        if (odd > 0) continue;
        texel = odd;
        const Prefiltered made = make(image, wanted);
        for (std::size_t map = 0; map < made.maps.size(); ++map)
            EXPECT_TRUE(stored(made, map).texels == stored(black, map).texels)
                << odd << " " << label(made, map);
    }
}

} // namespace
} // namespace lobelia::test
