#include <limits>

#include "prefilter_fixture.h"
#include "support/qualities.h"

// What a request is turned into, and what is refused.
namespace lobelia::test {
namespace {

void expect_refused(const auto& result, const std::string& what) {
    ASSERT_FALSE(result) << what;
    EXPECT_EQ(result.error().code, VK_ERROR_VALIDATION_FAILED_EXT) << what;
    EXPECT_GT(std::string(result.error().step).size(), 10u) << what;
}

TEST(PrefilterPlanTest, RefusesSizesThatAreNoPowersOfTwo) {
    const float exponents[] = {64};
    for (std::uint32_t size :
         {0u, 1u, 2u, 8u, 15u, 17u, 48u, 100u, 255u, 257u, 3072u, 8192u, 1u << 31, ~0u})
        expect_refused(PrefilterPlan::make({.exponents = exponents, .source_size = size}),
                       "source size " + std::to_string(size));
}

TEST(PrefilterPlanTest, RefusesExponentsOutOfRange) {
    for (float odd :
         {-1e-30f, -1.0f, 1000001.0f, 1e7f, std::numeric_limits<float>::max(),
          std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
          std::numeric_limits<float>::quiet_NaN()}) {
        const float exponents[] = {1, odd, 64};
        expect_refused(PrefilterPlan::make({.exponents = exponents, .source_size = 64}),
                       "exponent " + std::to_string(odd));
    }
}

TEST(PrefilterPlanTest, RefusesToMakeNothing) {
    expect_refused(PrefilterPlan::make({.source_size = 64}), "no map");
}

TEST(PrefilterPlanTest, NamesTheMapsInTheOrderAskedForThenLambert) {
    const float exponents[] = {700, 0, 1e6f, 64, 64, 4.8f, -0.0f};
    for (const Quality quality : QUALITIES)
        for (std::uint32_t size : {16u, 64u, 256u, 1024u}) {
            const PrefilterPlan plan = value_of(PrefilterPlan::make({.exponents = exponents,
                                                                     .lambert = true,
                                                                     .quality = quality,
                                                                     .source_size = size}));
            ASSERT_EQ(plan.maps().size(), 8u);
            for (std::size_t i = 0; i < 7; ++i) {
                EXPECT_EQ(plan.maps()[i].exponent, exponents[i]);
                EXPECT_EQ(plan.maps()[i].filter, MapFilter::spline);
                EXPECT_EQ(plan.maps()[i].size % 8, 0u);
                EXPECT_GE(plan.maps()[i].size, 16u);
                EXPECT_LE(plan.maps()[i].size, std::max(size, 32u));
            }
            EXPECT_EQ(plan.maps()[7].exponent, 1);
            EXPECT_EQ(plan.maps()[7].filter, MapFilter::bilinear);
            EXPECT_EQ(plan.maps()[2].size, size); // as sharp as the source
            EXPECT_EQ(plan.maps()[3].size, plan.maps()[4].size);
            EXPECT_GE(plan.maps()[0].size, plan.maps()[3].size);
            EXPECT_GT(plan.scratch_size(), 0u);
            EXPECT_EQ(plan.state_size(), sizeof(PrefilterState));
        }
}

TEST(PrefilterPlanTest, SpendsLessOnALowExponentAlone) {
    const auto plan = [](std::vector<float> exponents) {
        return value_of(PrefilterPlan::make({.exponents = exponents, .source_size = 256}));
    };
    for (float low : {0.0f, 1.0f, 16.0f}) {
        EXPECT_LT(plan({low}).pass_count(), plan({low, 64}).pass_count()) << low;
        EXPECT_LT(plan({low}).pass_count(), plan({low, 2048}).pass_count()) << low;
        EXPECT_LT(plan({low}).scratch_size(), plan({low, 2048}).scratch_size()) << low;
    }
    // One more exponent costs one more pass where the chain is there already.
    EXPECT_EQ(plan({700, 2048, 1000}).pass_count(), plan({700, 2048}).pass_count() + 1);
}

class PrefilterMisuseTest : public PrefilterTest {
protected:
    PrefilterPlan plan = plan_for({{1, 64}}, 64);
    std::vector<host::GpuImage> images = images_for(plan);
    host::GpuImage source = on_device(gpu, even_cube(64, 1, 1, 1));
    host::GpuBuffer scratch =
        storage(plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    host::GpuBuffer state = storage(plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    std::vector<CubeMap> maps{cube_of(images[0]), cube_of(images[1])};

    void expect_not_bound(const CubeMap& from, const std::string& what) {
        expect_refused(prefilter.bind(plan, from, maps, scratch.handle(), state.handle()), what);
    }
};

TEST_F(PrefilterMisuseTest, BindsWhatThePlanSays) {
    EXPECT_TRUE(prefilter.bind(plan, cube_of(source), maps, scratch.handle(), state.handle()));
}

TEST_F(PrefilterMisuseTest, RefusesASourceOfAnotherSize) {
    CubeMap other = cube_of(source);
    other.size = 32;
    expect_not_bound(other, "size of the source");
}

TEST_F(PrefilterMisuseTest, RefusesAnotherNumberOfMaps) {
    maps.pop_back();
    expect_not_bound(cube_of(source), "one map");
    maps = {cube_of(images[0]), cube_of(images[1]), cube_of(images[1])};
    expect_not_bound(cube_of(source), "three maps");
    maps.clear();
    expect_not_bound(cube_of(source), "no map");
}

TEST_F(PrefilterMisuseTest, RefusesMapsOfOtherSizes) {
    maps[1].size *= 2;
    expect_not_bound(cube_of(source), "a map twice the size");
}

TEST_F(PrefilterMisuseTest, RefusesMapsOfOtherFormats) {
    maps[0].format = VK_FORMAT_R32G32B32A32_SFLOAT;
    expect_not_bound(cube_of(source), "a map of floats");
}

} // namespace
} // namespace lobelia::test
