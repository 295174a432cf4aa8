#include <lobelia/clipped_tables.h>

#include "prefilter_fixture.h"
#include "support/counting_device.h"
#include "support/qualities.h"

// Levels that outlive the maps they were made for: an edit of an exponent makes maps alone.
namespace lobelia::test {
namespace {

constexpr float SHARPEST = 4096; // that is edited to

PrefilterPlan plan_of(float exponent, Quality quality, std::uint32_t size) {
    return value_of(PrefilterPlan::make({.exponents = {&exponent, 1},
                                         .lambert = true,
                                         .ladder = ladder_for(Taps::two, exponent, exponent),
                                         .quality = quality,
                                         .levels_up_to = 2 * SHARPEST,
                                         .source_size = size}));
}

/// Maps and a ladder of a plan; the levels and the state buffer are lent.
struct Edit {
    PrefilterPlan plan;
    std::vector<host::GpuImage> images; // the ladder last
    PrefilterJob job;
};

class KeptLevelsTest : public PrefilterTest {
protected:
    Prefilter counted = value_of(Prefilter::create(counting_device(gpu)));

    Edit bind(const PrefilterPlan& plan, const host::GpuImage& source,
              const host::GpuBuffer& scratch, const host::GpuBuffer& state) {
        std::vector<host::GpuImage> images = images_for(plan);
        std::vector<CubeMap> maps;
        for (const host::GpuImage& image : images) maps.push_back(cube_of(image));
        images.push_back(value_of(
            gpu.create_image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                              .width = plan.ladder_size(),
                              .height = plan.ladder_size(),
                              .layers = 6 * plan.ladder().rungs,
                              .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT})));
        PrefilterJob job = value_of(counted.bind(plan, cube_of(source), maps, scratch.handle(),
                                                 state.handle(), images.back().handle()));
        return {plan, std::move(images), std::move(job)};
    }
    void record(const Edit& edit, std::uint32_t first) {
        Recorded::reset();
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            edit.job.record(commands, first, edit.plan.pass_count() - first);
        }));
        EXPECT_EQ(Recorded::now().dispatches, edit.plan.pass_count() - first);
    }
    host::GpuBuffer scratch_for(const PrefilterPlan& plan) {
        return storage(plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    }
    host::GpuBuffer state_for(const PrefilterPlan& plan) {
        return storage(plan.state_size(),
                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    }
};

TEST_F(KeptLevelsTest, GiveMapsOfOtherExponentsTheSameBits) {
    for (const Quality quality : QUALITIES)
        for (const std::uint32_t size : {32u, 128u}) {
            const host::GpuImage source =
                on_device(gpu, image_of(oracle::random_cube(oracle::Scene::suns, int(size), 7)));
            const PrefilterPlan first = plan_of(64, quality, size);
            const host::GpuBuffer scratch = scratch_for(first), state = state_for(first);
            record(bind(first, source, scratch, state), 0);
            for (const float exponent : {0.5f, 44.0f, 1000.0f}) {
                SCOPED_TRACE("n " + std::to_string(exponent) + " source " + std::to_string(size));
                const PrefilterPlan plan = plan_of(exponent, quality, size);
                ASSERT_TRUE(plan.shares_levels(first));
                ASSERT_EQ(plan.scratch_size(), first.scratch_size());
                const Edit edited = bind(plan, source, scratch, state);
                record(edited, plan.first_map_pass());

                const host::GpuBuffer fresh_scratch = scratch_for(plan),
                                      fresh_state = state_for(plan);
                const Edit fresh = bind(plan, source, fresh_scratch, fresh_state);
                record(fresh, 0);
                EXPECT_EQ(std::memcmp(state.data(), fresh_state.data(), state.size()), 0);
                for (std::size_t i = 0; i < fresh.images.size(); ++i) {
                    const auto texels = [&](const Edit& edit) {
                        return value_of(gpu.download(edit.images[i],
                                                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL))
                            .texels;
                    };
                    EXPECT_EQ(texels(edited), texels(fresh)) << "image " << i;
                }
            }
        }
}

TEST(KeptLevelsPlanTest, CostAnEditNoMoreThanItsMaps) {
    const PrefilterPlan plan = plan_of(1000, Quality::normal, 256);
    EXPECT_EQ(plan.pass_count() - plan.first_map_pass(), 2 + plan.ladder().rungs);
}

TEST(KeptLevelsPlanTest, AreThoseOfOneSourceQualityAndReach) {
    const PrefilterPlan plan = plan_of(64, Quality::normal, 256);
    EXPECT_FALSE(plan.shares_levels(plan_of(64, Quality::high, 256)));
    EXPECT_FALSE(plan.shares_levels(plan_of(64, Quality::normal, 128)));
    const float exponent = 64;
    const auto other = [&](float levels_up_to) {
        return value_of(PrefilterPlan::make(
            {.exponents = {&exponent, 1}, .levels_up_to = levels_up_to, .source_size = 256}));
    };
    EXPECT_FALSE(plan.shares_levels(other(64)));
    EXPECT_FALSE(plan.shares_levels(other(0)));
    EXPECT_FALSE(other(0).shares_levels(other(0)));
    EXPECT_TRUE(plan.shares_levels(other(2 * SHARPEST)));
}

TEST(KeptLevelsPlanTest, RefuseSharperMaps) {
    const float exponent = 64;
    for (const float reach : {63.0f, 4.2e6f, -1.0f, std::nanf("")}) {
        const auto refused = PrefilterPlan::make(
            {.exponents = {&exponent, 1}, .levels_up_to = reach, .source_size = 64});
        ASSERT_FALSE(refused) << reach;
        EXPECT_EQ(refused.error().code, VK_ERROR_VALIDATION_FAILED_EXT);
    }
}

// Dropping what no pixel sees changes nothing of the rest.
TEST_F(KeptLevelsTest, LeaveBroadMapsTheSameBitsWithoutSharpOnes) {
    const std::vector<float> low{0.5f, 4.8f, 44};
    for (const Quality quality : QUALITIES)
        for (const std::uint32_t size : {16u, 128u}) {
            const host::GpuImage source =
                on_device(gpu, image_of(oracle::random_cube(oracle::Scene::suns, int(size), 7)));
            std::vector<float> all = low;
            all.insert(all.end(), {45, 300, 4096});
            const Prefiltered mixed = make(source, {all, true, quality});
            const Prefiltered broad = make(source, {low, true, quality});
            const Prefiltered diffuse = make(source, {{}, true, quality});
            for (std::size_t i = 0; i < low.size(); ++i)
                EXPECT_EQ(stored(mixed, i).texels, stored(broad, i).texels) << low[i];
            EXPECT_EQ(stored(mixed, all.size()).texels, stored(diffuse, 0).texels)
                << "source " << size;
        }
}

} // namespace
} // namespace lobelia::test
