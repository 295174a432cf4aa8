#include <cmath>
#include <limits>

#include "support/gpu_test.h"
#include "support/sampled.h"

namespace lobelia::test {
namespace {

using oracle::Rgb;
using oracle::Scene;

// Relative error of one level made of the one before: that of the solid angles and some roundings.
constexpr double STEP = 2e-6;
constexpr double HALF = 0x1p-11; // of a half, rounded to the nearest

class MipsTest : public GpuTest {
protected:
    std::vector<host::Image> levels_of(const oracle::Source& source, VkFormat format,
                                       MipWeights weights = MipWeights::solid_angle) {
        const host::GpuImage mips = mips_of(gpu, on_device(gpu, image_of(source)), format, weights);
        std::vector<host::Image> levels;
        for (std::uint32_t level = 0; level < mips.description().levels; ++level)
            levels.push_back(
                value_of(gpu.download(mips, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, level)));
        return levels;
    }
};

/// The average over the texels of `source` that texel (x, y) of a level of `size` covers.
Rgb block_average(const oracle::Source& source, int layer, int x, int y, int size,
                  MipWeights weights) {
    const int block = source.width() / size;
    Rgb sum{};
    double total = 0;
    for (int j = y * block; j < (y + 1) * block; ++j)
        for (int i = x * block; i < (x + 1) * block; ++i) {
            const double weight = weights == MipWeights::equal ? 1.0 : source.solid_angle(i, j);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * source.texel(layer, i, j)[c];
            total += weight;
        }
    for (double& channel : sum) channel /= total;
    return sum;
}

void expect_averages(const oracle::Source& source, const std::vector<host::Image>& levels,
                     double rounding, MipWeights weights = MipWeights::solid_angle) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const host::Image& image = levels[level];
        const int size = int(image.width);
        for (int layer = 0; layer < 6; ++layer)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const Rgb expected = block_average(source, layer, x, y, size, weights);
                    const auto found =
                        image.texel(std::uint32_t(layer), std::uint32_t(x), std::uint32_t(y));
                    for (std::size_t c = 0; c < 3; ++c)
                        ASSERT_NEAR(double(found[c]) / expected[c], 1.0,
                                    double(level) * STEP + double(level + 1) * rounding + 1e-14)
                            << "level " << level << " texel " << x << " " << y << " of " << layer;
                }
    }
}

TEST_F(MipsTest, AreAveragesBySolidAngle) {
    for (int size : {1, 2, 16, 64})
        for (const Scene scene : {Scene::noise, Scene::suns}) {
            SCOPED_TRACE(std::string(oracle::name(scene)) + " " + std::to_string(size));
            const oracle::Source source = oracle::random_cube(scene, size, 3);
            expect_averages(source, levels_of(source, VK_FORMAT_R32G32B32A32_SFLOAT), 0.0);
        }
}

TEST_F(MipsTest, ArePlainAveragesWithEqualWeights) {
    const oracle::Source source = oracle::random_cube(Scene::noise, 32, 7);
    const auto levels = levels_of(source, VK_FORMAT_R32G32B32A32_SFLOAT, MipWeights::equal);
    expect_averages(source, levels, 0.0, MipWeights::equal);
}

TEST_F(MipsTest, AreTheSameInHalves) {
    const oracle::Source source = oracle::random_cube(Scene::noise, 32, 4);
    expect_averages(source, levels_of(source, VK_FORMAT_R16G16B16A16_SFLOAT), HALF);
}

TEST_F(MipsTest, KeepTheMean) {
    const oracle::Source source = oracle::random_cube(Scene::suns, 64, 5);
    const Rgb mean = source.mean();
    const auto levels = levels_of(source, VK_FORMAT_R32G32B32A32_SFLOAT);
    for (std::size_t level = 0; level < levels.size(); ++level)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(source_of(levels[level]).mean()[c] / mean[c], 1.0,
                        double(level) * STEP + 1e-12)
                << level;
}

TEST_F(MipsTest, AreSaneWhateverTheTexelsAre) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    struct Case {
        float from, whole, half;
    };
    for (const Case& odd : {Case{nan, 0, 0},
                            {-nan, 0, 0},
                            {-1, 0, 0},
                            {-infinity, 0, 0},
                            {infinity, 0x1p120f, 65504},
                            {1e9f, 1e9f, 65504},
                            {0.5f, 0.5f, 0.5f}}) {
        host::Image image = image_of(oracle::random_cube(Scene::noise, 4, 6));
        image.texel(2, 1, 3)[1] = odd.from;
        const host::GpuImage cube = on_device(gpu, image);
        for (const VkFormat format :
             {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT}) {
            const host::GpuImage mips = mips_of(gpu, cube, format);
            for (std::uint32_t level = 0; level < 3; ++level) {
                const host::Image found =
                    value_of(gpu.download(mips, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, level));
                for (const float value : found.texels)
                    ASSERT_TRUE(value >= 0 && value <= 0x1p120f) << odd.from;
                if (level > 0) continue;
                EXPECT_EQ(found.texel(2, 1, 3)[1],
                          format == VK_FORMAT_R16G16B16A16_SFLOAT ? odd.half : odd.whole);
            }
        }
    }
}

TEST_F(MipsTest, RefuseWhatTheyCannotBeMadeOf) {
    const Mips mips = value_of(Mips::create(gpu.device()));
    const VkFormat whole = VK_FORMAT_R32G32B32A32_SFLOAT;
    const CubeMap source{.format = whole, .size = 16};
    EXPECT_FALSE(mips.bind({.format = whole, .size = 3}, {.format = whole, .size = 3}));
    EXPECT_FALSE(mips.bind(source, {.format = whole, .size = 8}));
    EXPECT_FALSE(mips.bind(source, {.format = whole, .size = 16, .levels = 6}));
    EXPECT_FALSE(mips.bind(source, {.format = whole, .size = 16, .levels = 0}));
    const auto job = mips.bind(source, {.format = VK_FORMAT_R8G8B8A8_UNORM, .size = 16});
    ASSERT_FALSE(job);
    EXPECT_STREQ(job.error().step, "mips have format R32G32B32A32_SFLOAT or R16G16B16A16_SFLOAT");
}

} // namespace
} // namespace lobelia::test
