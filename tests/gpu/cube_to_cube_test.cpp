#include <algorithm>
#include <cmath>
#include <limits>

#include <lobelia/cube_to_cube.h>

#include "panorama_fixture.h"
#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"

// CubeToCube against sums over the overlaps of texels in double.
namespace lobelia::test {
namespace {

// Of the shader's solid angles and sums, in floats: below 1e-6 for each weight, and roundings of as
// many terms as a texel has.
constexpr double TOLERANCE = 4e-6;

struct Sizes {
    std::uint32_t from, to;
};
constexpr Sizes SIZES[] = {{1, 16}, {3, 16}, {16, 16}, {20, 16}, {100, 16}, {48, 64}, {96, 32}};

class CubeToCubeTest : public GpuTest {
protected:
    CubeToCube pass = value_of(CubeToCube::create(gpu.device()));

    Image resample(const Image& cube, std::uint32_t size, std::uint32_t rows = ~0u) {
        const host::GpuImage source = on_device(gpu, cube);
        const host::GpuImage target = cube_to_fill(gpu, size);
        const CubeToCubeJob job = value_of(pass.bind(cube_of(source), cube_of(target)));
        for (std::uint32_t first = 0; first < job.rows();) {
            const std::uint32_t count = std::min(rows, job.rows() - first);
            value_of(
                gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
            first += count;
        }
        return value_of(gpu.download(target, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
    }
};

Image noise_cube(std::uint32_t size, std::uint64_t seed) {
    return image_of(oracle::random_cube(oracle::Scene::noise, int(size), seed));
}

// Solid angle between the origin of a face and a point of it, the usual four of which cancel.
double corner(double u, double v) {
    return std::atan2(u * v, std::sqrt(1 + u * u + v * v));
}

double solid_angle(double left, double top, double right, double bottom) {
    return corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top);
}

oracle::Rgb average(const Image& cube, std::uint32_t face, std::uint32_t x, std::uint32_t y,
                    std::uint32_t size) {
    const auto edge = [](std::uint32_t i, std::uint32_t count) { return 2.0 * i / count - 1; };
    oracle::Rgb sum{};
    double all = 0;
    for (std::uint32_t j = 0; j < cube.height; ++j)
        for (std::uint32_t i = 0; i < cube.width; ++i) {
            const double left = std::max(edge(x, size), edge(i, cube.width));
            const double right = std::min(edge(x + 1, size), edge(i + 1, cube.width));
            const double top = std::max(edge(y, size), edge(j, cube.width));
            const double bottom = std::min(edge(y + 1, size), edge(j + 1, cube.width));
            if (left >= right || top >= bottom) continue;
            const double angle = solid_angle(left, top, right, bottom);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += angle * double(cube.texel(face, i, j)[c]);
            all += angle;
        }
    for (double& channel : sum) channel /= all;
    return sum;
}

} // namespace

TEST_F(CubeToCubeTest, AveragesWhatATexelCovers) {
    for (const auto& [from, to] : SIZES) {
        SCOPED_TRACE(std::to_string(from) + " to " + std::to_string(to));
        const Image cube = noise_cube(from, from), made = resample(cube, to);
        for (std::uint32_t face = 0; face < 6; ++face)
            for (std::uint32_t y = 0; y < to; ++y)
                for (std::uint32_t x = 0; x < to; ++x) {
                    const oracle::Rgb exact = average(cube, face, x, y, to);
                    for (std::size_t c = 0; c < 3; ++c)
                        ASSERT_NEAR(made.texel(face, x, y)[c], exact[c], TOLERANCE * exact[c]);
                    ASSERT_EQ(made.texel(face, x, y)[3], 1.0f);
                }
        const oracle::Rgb before = mean(cube), after = mean(made);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(after[c], before[c], TOLERANCE * before[c]);
    }
}

TEST_F(CubeToCubeTest, KeepsAConstant) {
    Image cube = noise_cube(20, 1);
    std::fill(cube.texels.begin(), cube.texels.end(), 0.3f);
    for (const std::uint32_t size : {16u, 32u}) {
        const Image made = resample(cube, size);
        for (std::size_t i = 0; i < made.texels.size(); ++i)
            ASSERT_EQ(made.texels[i], i % 4 == 3 ? 1.0f : 0.3f);
    }
}

TEST_F(CubeToCubeTest, TakesWhatIsNoRadianceForNone) {
    Image cube = noise_cube(32, 2);
    std::fill(cube.texels.begin(), cube.texels.end(), 0.0f);
    cube.texel(0, 0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    cube.texel(0, 0, 0)[1] = -1.0f;
    for (const auto& [x, y] : {std::pair{0u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}})
        cube.texel(0, x, y)[2] = std::numeric_limits<float>::infinity();
    const Image made = resample(cube, 16);
    EXPECT_EQ(made.texel(0, 0, 0)[0], 0.0f);
    EXPECT_EQ(made.texel(0, 0, 0)[1], 0.0f);
    EXPECT_EQ(made.texel(0, 0, 0)[2], 0x1p120f);
}

TEST_F(CubeToCubeTest, GivesTheSameBitsInParts) {
    const Image cube = noise_cube(40, 3), whole = resample(cube, 32);
    for (const std::uint32_t rows : {1u, 7u, 32u, 100u})
        EXPECT_EQ(resample(cube, 32, rows).texels, whole.texels) << rows;
}

TEST_F(CubeToCubeTest, Refuses) {
    const CubeMap sound{.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = 16};
    const auto refused = [&](CubeMap source, CubeMap target) {
        const auto job = pass.bind(source, target);
        return job ? std::string() : std::string(job.error().step);
    };
    CubeMap none = sound, half = sound, huge = sound;
    none.size = 0;
    half.format = VK_FORMAT_R16G16B16A16_SFLOAT;
    huge.size = 16384;
    EXPECT_NE(refused(none, sound).find("1 to 16384"), std::string::npos);
    EXPECT_NE(refused(sound, none).find("1 to 16384"), std::string::npos);
    EXPECT_NE(refused(huge, sound).find("200 times"), std::string::npos);
    EXPECT_NE(refused(sound, half).find("R32G32B32A32"), std::string::npos);
}

} // namespace lobelia::test
