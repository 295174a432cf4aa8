#include "exact_fixture.h"

#include <cfloat>
#include <limits>

// What holds to the last bit, at the ends of the range of numbers, and what is refused.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;
using oracle::Scene;
using oracle::Source;

class ExactBitsTest : public ExactTest {};

TEST_F(ExactBitsTest, ScaleWithTheLightBitForBit) {
    const Source source = oracle::random_cube(Scene::noise, 4, 11);
    const Directions axes = oracle::test_directions(12, 12);
    for (float n : {0.0f, 1.0f, 4.8f, 1e3f}) {
        const std::vector<Average> before = averages(source, n, axes);
        for (int power : {-60, -10, 10, 60, 110}) {
            Source scaled = source;
            for (int face = 0; face < 6; ++face)
                for (int i = 0; i < 16; ++i)
                    for (double& channel : scaled.texel(face, i % 4, i / 4))
                        channel = std::ldexp(channel, power);
            const std::vector<Average> after = averages(scaled, n, axes);
            for (std::size_t i = 0; i < axes.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(after[i][c], std::ldexp(before[i][c], power))
                        << "n " << n << " times 2^" << power;
        }
    }
}

TEST_F(ExactBitsTest, KeepTheChannelsApart) {
    const Source source = oracle::random_panorama(Scene::noise, 17, 9, 13);
    host::Image other = image_of(source);
    for (std::size_t i = 0; i < other.texels.size(); i += 4)
        other.texels[i] = i % 12 == 0 ? std::numeric_limits<float>::quiet_NaN() : 1e30f;
    const Directions axes = oracle::test_directions(8, 14);
    for (float n : {1.0f, 64.0f}) {
        const std::vector<Average> before = averages(source, n, axes);
        const std::vector<Average> after = averages(on_device(gpu, other), n, axes);
        for (std::size_t i = 0; i < axes.size(); ++i)
            for (std::size_t c = 1; c < 4; ++c) EXPECT_EQ(after[i][c], before[i][c]);
    }
}

TEST_F(ExactBitsTest, GiveTheSameBitsHoweverTheyAreRecorded) {
    const std::vector<ExactQuery> queries = unclipped(oracle::test_directions(9, 17));
    for (const Source& source : {oracle::random_panorama(Scene::suns, 64, 32, 15),
                                 oracle::random_cube(Scene::suns, 40, 16)}) {
        const host::GpuImage image = on_device(gpu, image_of(source));
        for (const ExactSettings& settings : {ExactSettings{.exponent = 1},
                                              {.exponent = 300},
                                              {.exponent = 300, .clipped = true}}) {
            const std::vector<Average> once = ask(image, settings, queries);
            EXPECT_EQ(ask(image, settings, queries), once);
            EXPECT_EQ(ask(image, settings, queries, {1, 2, 0, 5}), once);
            for (std::uint64_t nodes : {1ull, 1ull << 40}) {
                ExactSettings other = settings;
                other.nodes_per_step = nodes;
                EXPECT_EQ(ask(image, other, queries, {2, 1}), once) << nodes << " nodes a step";
                EXPECT_GE(steps, nodes == 1 ? 3u : 1u); // four queries a workgroup
            }
        }
    }
}

TEST_F(ExactBitsTest, DoNotOverflow) {
    for (const Source& source :
         {oracle::panorama_of(5, 3, [](Direction) { return grey(double(FLT_MAX)); }),
          oracle::cube_of(3, [](Direction) { return grey(double(FLT_MAX)); })})
        for (float n : {0.0f, 1.0f, 4.8f, 1e4f})
            for (const Average& found : averages(source, n, oracle::test_directions(16, 18))) {
                EXPECT_TRUE(std::isfinite(found[0])) << shape_of(source) << " n " << n;
                EXPECT_NEAR(double(found[0]) / double(FLT_MAX), 1, 1e-5);
            }
}

TEST_F(ExactBitsTest, LeaveBlackBlack) {
    const auto black = [](Direction) { return Rgb{}; };
    for (const Source& source : {oracle::panorama_of(5, 3, black), oracle::cube_of(3, black)})
        for (float n : {0.0f, 4.8f, 1e4f})
            for (const Average& found : averages(source, n, oracle::test_directions(8, 19)))
                for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(found[c], 0.0f);
}

TEST_F(ExactBitsTest, RefuseWhatTheyCannotDo) {
    const Source light = oracle::panorama_of(2, 1, [](Direction) { return grey(1); });
    const host::GpuImage image = on_device(gpu, image_of(light));
    const Panorama panorama = panorama_of(image);
    const host::GpuBuffer buffer = value_of(gpu.create_buffer(
        1 << 20, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        host::Memory::device));
    const auto expect_refused = [&](const auto& source, const ExactSettings& settings,
                                    const char* why) {
        const auto sizes = Exact::sizes(source, settings);
        const auto job =
            exact.bind(source, settings, buffer.handle(), buffer.handle(), buffer.handle());
        ASSERT_FALSE(sizes) << why;
        ASSERT_FALSE(job) << why;
        for (const Error& error : {sizes.error(), job.error()}) {
            EXPECT_EQ(error.code, VK_ERROR_VALIDATION_FAILED_EXT);
            EXPECT_NE(std::string(error.step).find(why), std::string::npos) << error.step;
        }
    };
    for (float n :
         {-1.0f, -1e-30f, 1.000001e6f, 1e7f, FLT_MAX, std::numeric_limits<float>::infinity(),
          std::numeric_limits<float>::quiet_NaN()})
        expect_refused(panorama, {.exponent = n, .query_count = 1}, "0 to 1e6");
    expect_refused(panorama, {.query_count = 0}, "empty");
    expect_refused(panorama, {.query_count = 1, .nodes_per_step = 0}, "nodes");
    expect_refused(Panorama{image.handle(), panorama.format, 0, 1}, {.query_count = 1}, "32768");
    expect_refused(Panorama{image.handle(), panorama.format, 1, 32769}, {.query_count = 1},
                   "32768");
    expect_refused(CubeMap{image.handle(), panorama.format, 0}, {.query_count = 1}, "32768");
    for (float n : {-0.0f, 1e6f})
        EXPECT_TRUE(Exact::sizes(panorama, {.exponent = n, .query_count = 1})) << n;
}

} // namespace
} // namespace lobelia::test
