#include <cmath>
#include <limits>

#include "support/gpu_test.h"
#include "support/oracle.h"
#include "support/sampled.h"

namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Scene;

using Averages = std::vector<std::array<float, 4>>;
using Directions = std::vector<Direction>;

class ImportanceTest : public GpuTest {
protected:
    host::GpuImage source_for(const oracle::Source& cube,
                              VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT) {
        return mips_of(gpu, on_device(gpu, image_of(cube)), format);
    }
};

TEST_F(ImportanceTest, LeavesConstantLightAsItIs) {
    const oracle::Source cube = oracle::cube_of(16, [](Direction) {
        return oracle::Rgb{1, 0.18, 37};
    });
    const Directions axes = oracle::test_directions(20, 1);
    for (const VkFormat format : {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT}) {
        const host::GpuImage source = source_for(cube, format);
        const double stored = format == VK_FORMAT_R16G16B16A16_SFLOAT ? 0x1p-11 : 0;
        for (const bool filtered : {false, true})
            for (std::uint32_t samples : {1u, 32u, 300u, 65535u}) {
                // Roundings of a sum of sums of up to 256 each, and of what is fetched; the levels'
                // own errors are those of MipsTest.
                const double sums =
                    (std::min(samples, 256u) + samples / 256 + 8) * 0x1p-24 + (filtered ? 8e-6 : 0);
                for (float exponent : {0.0f, 1.0f, 64.0f, 1e6f})
                    for (const auto& average :
                         sampled(gpu, source,
                                 {.exponent = exponent, .samples = samples, .filtered = filtered},
                                 axes)) {
                        EXPECT_NEAR(average[0], 1.0, stored + sums) << samples;
                        EXPECT_NEAR(average[1] / 0.18f, 1.0, stored + sums) << samples;
                        EXPECT_NEAR(average[2] / 37.0f, 1.0, stored + sums) << samples;
                        EXPECT_EQ(average[3], 1.0f);
                    }
            }
    }
}

TEST_F(ImportanceTest, ScalesALinearEnvironmentByTheClosedForm) {
    // Funk-Hecke: of radiance 1 + d.a / 2 the second part keeps its shape and is scaled by
    // (n + 1) / (n + 2).
    const Direction a = oracle::test_directions(7, 2)[6];
    const host::GpuImage source = source_for(oracle::cube_of(256, [&](Direction d) {
        const double value = 1 + 0.5 * dot(d, a);
        return oracle::Rgb{value, value, value};
    }));
    // Koksma and Hlawka: the variation of the integrand over share and turn, at most 9/2 + 1/2
    // here, times the points' discrepancy, at most (log2(N) / 3 + 2) / N (De Clerck 1986, "A Method
    // for Exact Calculation of the Stardiscrepancy of Plane Sets Applied to the Sequences of
    // Hammersley"; half a point more, since they are moved by half a stratum). Fetches between
    // texels of a linear radiance err by the square of a texel, levels 1 to 3 included.
    constexpr std::uint32_t SAMPLES = 16384;
    const double bound = 5 * (14.0 / 3 + 2) / SAMPLES + 2e-4;
    const Directions axes = oracle::test_directions(60, 3);
    for (const bool filtered : {false, true})
        for (const double n : {0.0, 1.0, 4.8, 64.0, 1e4}) {
            const Averages averages =
                sampled(gpu, source,
                        {.exponent = float(n), .samples = SAMPLES, .filtered = filtered}, axes);
            for (std::size_t i = 0; i < axes.size(); ++i)
                EXPECT_NEAR(averages[i][0], 1 + 0.5 * dot(axes[i], a) * (n + 1) / (n + 2), bound)
                    << "n " << n << " filtered " << filtered;
        }
}

// Three black skies, one a channel, with a sun of one texel in each face.
struct Suns {
    static constexpr int SIZE = 64;
    static constexpr double RADIANCE = 1e4;

    struct Sun {
        Direction direction;
        double energy; // radiance times solid angle
    };

    oracle::Source skies = oracle::cube_of(SIZE, [](Direction) { return oracle::Rgb{}; });
    std::array<std::vector<Sun>, 3> suns;

    Suns() {
        oracle::Random random(4);
        for (int face = 0; face < 6; ++face)
            for (std::size_t c = 0; c < 3; ++c) {
                const int x = 2 + random.below(SIZE - 4);
                const int y = 2 + random.below(SIZE - 4);
                skies.texel(face, x, y)[c] = RADIANCE;
                suns[c].push_back(
                    {skies.direction(face, x, y), RADIANCE * skies.solid_angle(x, y)});
            }
    }

    /// P_n of one sky, each sun being a point.
    double average(std::size_t sky, Direction axis, double n) const {
        double sum = 0;
        for (const Sun& sun : suns[sky])
            sum += sun.energy * (n + 1) / (2 * oracle::PI) *
                   std::pow(std::max(dot(axis, sun.direction), 0.0), n);
        return sum;
    }

    /// Mean over the sphere of a sky's squared radiance as it is fetched: between a sun's texel and
    /// its neighbours it falls linearly, along both axes, which leaves (2/3)^2 of the texel's own.
    double mean_square(std::size_t sky) const {
        double sum = 0;
        for (const Sun& sun : suns[sky]) sum += sun.energy;
        return RADIANCE * sum / (4 * oracle::PI) * 4 / 9;
    }
};

TEST_F(ImportanceTest, ErrsWithoutFilteringAsTheRootOfTheNumberOfSamples) {
    constexpr double N = 1;
    const Suns suns;
    const host::GpuImage source = source_for(suns.skies);
    const Directions axes = oracle::test_directions(131072, 5);
    const double count = 3.0 * double(axes.size());
    double mean_square = 0;
    for (std::size_t sky = 0; sky < 3; ++sky) mean_square += suns.mean_square(sky) / 3;
    for (std::uint32_t samples : {16u, 64u, 256u}) {
        const Averages averages =
            sampled(gpu, source, {.exponent = N, .samples = samples, .filtered = false}, axes);
        double squared_error = 0;
        double squared_average = 0;
        for (std::size_t i = 0; i < axes.size(); ++i)
            for (std::size_t sky = 0; sky < 3; ++sky) {
                const double average = suns.average(sky, axes[i], N);
                squared_error += std::pow(averages[i][sky] - average, 2) / count;
                squared_average += average * average / count;
            }
        // Of independent samples the mean squared error is the mean squared radiance over their
        // number. Of these, no two see one sun and fewer see two, which takes off at most the mean
        // squared average. Chance: a count of the samples that see a sun, whose squares spread,
        // 1.8 / sqrt(count), and the frames, which cannot turn evenly with the axis on a sphere,
        // 0.05 as measured over eight such skies; thrice both.
        const double expected = mean_square / samples;
        const double seen = 4.0 * 6 / (6 * Suns::SIZE * Suns::SIZE) * count * samples;
        const double chance = 3 * (1.8 / std::sqrt(seen) + 0.05);
        EXPECT_LE(squared_error / expected, 1 + chance) << samples;
        EXPECT_GE(squared_error / expected, 1 - squared_average / expected - chance) << samples;
        RecordProperty("share_" + std::to_string(samples),
                       std::to_string(squared_error / expected));
    }
}

TEST_F(ImportanceTest, IsTheSameBitsHoweverItIsSplit) {
    const host::GpuImage source = source_for(oracle::random_cube(Scene::noise, 16, 6));
    const Directions axes = oracle::test_directions(200, 7);
    for (const bool filtered : {false, true}) {
        ImportanceSettings settings{.exponent = 8, .samples = 600, .filtered = filtered};
        const Averages whole = sampled(gpu, source, settings, axes);
        EXPECT_EQ(whole, sampled(gpu, source, settings, axes, {1, 1}));
        settings.samples_per_step = 20000; // 78 directions
        EXPECT_EQ(sampled(gpu, source, settings, axes),
                  sampled(gpu, source, settings, axes, {2, 1, 3}));
    }
}

TEST_F(ImportanceTest, SeesEveryTexelOfTheLobeWithFiltering) {
    const oracle::Source sky = oracle::random_cube(Scene::noise, 64, 10);
    const host::GpuImage source = source_for(sky);
    const Directions axes = oracle::test_directions(60, 11);
    constexpr std::uint32_t SAMPLES = 64;
    for (const double n : {1.0, 16.0, 64.0}) {
        const auto truth = oracle::lobe_averages(sky, axes, n);
        const auto squared_error = [&](bool filtered) {
            const Averages averages =
                sampled(gpu, source,
                        {.exponent = float(n), .samples = SAMPLES, .filtered = filtered}, axes);
            double sum = 0;
            for (std::size_t i = 0; i < axes.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    sum += std::pow(averages[i][c] / truth[i][c] - 1, 2);
            return sum;
        };
        // Of the noise's variance, N fetches between texels keep 4/9 / N. The truth itself varies
        // by 1 / M, M = 1 / (the density's square integral times a texel) being the texels under
        // the lobe: the error of an answer that looked nowhere and knew the mean. Filtering does
        // better than that.
        const double texel = 4 * oracle::PI / (6 * 64 * 64);
        const double under_lobe = 2 * oracle::PI * (2 * n + 1) / ((n + 1) * (n + 1) * texel);
        EXPECT_LT(squared_error(true) / squared_error(false), SAMPLES * 9.0 / 4 / under_lobe)
            << "n " << n;
    }
}

TEST_F(ImportanceTest, StaysFiniteUnderEndlessLight) {
    const float infinity = std::numeric_limits<float>::infinity();
    const host::GpuImage source =
        mips_of(gpu, on_device(gpu, [&] {
                    host::Image image = image_of(oracle::random_cube(Scene::noise, 8, 8));
                    std::fill(image.texels.begin(), image.texels.end(), infinity);
                    return image;
                }()));
    for (const bool filtered : {false, true})
        for (std::uint32_t samples : {1u, 4096u})
            for (const auto& average :
                 sampled(gpu, source, {.exponent = 2, .samples = samples, .filtered = filtered},
                         oracle::test_directions(20, 9)))
                EXPECT_NEAR(average[0] / 0x1p120f, 1.0, 1e-4) << samples;
}

TEST_F(ImportanceTest, RefusesWhatItCannotSample) {
    const Importance importance = value_of(Importance::create(gpu.device()));
    const CubeMap source{.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = 16, .levels = 5};
    const auto refused = [&](const CubeMap& cube, const ImportanceSettings& settings) {
        const auto job = importance.bind(cube, settings, VK_NULL_HANDLE, VK_NULL_HANDLE);
        return job ? "" : job.error().step;
    };
    EXPECT_STREQ(refused(source, {.exponent = -1, .query_count = 1}),
                 "exponents are from 0 to 1e6");
    EXPECT_STREQ(refused(source, {.exponent = std::nanf(""), .query_count = 1}),
                 "exponents are from 0 to 1e6");
    for (std::uint32_t samples : {0u, 65536u})
        EXPECT_STREQ(refused(source, {.samples = samples, .query_count = 1}),
                     "samples are 1 to 65535");
    EXPECT_STREQ(refused(source, {}), "the list of directions is empty");
    EXPECT_STREQ(refused({.format = source.format}, {.query_count = 1}), "a cube map has a size");
    EXPECT_STREQ(refused({.format = source.format, .size = 16}, {.query_count = 1}),
                 "filtered importance sampling reads all levels of a cube map, down to 1 texel");
}

} // namespace
} // namespace lobelia::test
