#include "prefilter_fixture.h"
#include "support/counting_device.h"

// Maps of an environment that lives, made over several frames.
namespace lobelia::test {
namespace {

/// Rates by which every pass takes its share of 1000 ms in proportion to its invocations.
std::vector<PassRate> rates_for(const PrefilterPlan& plan) {
    double invocations = 0;
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i)
        invocations += double(plan.pass(i).invocations);
    std::vector<PassRate> rates;
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i) {
        const PrefilterPass pass = plan.pass(i);
        if (predicted_milliseconds(rates, pass.name, 1) == 0)
            rates.push_back({pass.name, 1000 / invocations * double(pass.invocations) / pass.work});
    }
    return rates;
}

double total(const PrefilterPlan& plan, std::span<const PassRate> rates) {
    double sum = 0;
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i)
        sum += predicted_milliseconds(rates, plan.pass(i).name, plan.pass(i).work);
    return sum;
}

TEST_F(PrefilterTest, MakesMapsInPiecesWithTheSameBits) {
    const host::GpuImage source =
        on_device(gpu, image_of(oracle::random_cube(oracle::Scene::suns, 128, 5)));
    const std::vector<float> exponents{0.5f, 8, 64, 700, 2048};
    const Prefiltered whole = make(source, {exponents, true});
    const PrefilterPlan& plan = whole.plan;
    const std::vector<PassRate> rates = rates_for(plan);

    // The front stays as it is while the back is made, frame by frame.
    const Prefiltered front = make(on_device(gpu, even_cube(128, 1, 2, 3)), {exponents, true});
    const std::vector<float> shown = stored(front, 0).texels;
    const Prefilter counted = value_of(Prefilter::create(counting_device(gpu)));
    const std::vector<host::GpuImage> images = images_for(plan);
    std::vector<CubeMap> maps;
    for (const host::GpuImage& image : images) maps.push_back(cube_of(image));
    const host::GpuBuffer scratch =
        storage(plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const host::GpuBuffer state = storage(plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const PrefilterJob job =
        value_of(counted.bind(plan, cube_of(source), maps, scratch.handle(), state.handle()));

    const double budget = total(plan, rates) / 16;
    const std::uint32_t told = job.frames(budget, rates);
    EXPECT_GE(told, 16u);
    EXPECT_LE(told, 17u);
    std::uint32_t frames = 0;
    Recorded::reset();
    for (PrefilterPosition at; at.pass < plan.pass_count(); ++frames) {
        value_of(gpu.submit(
            [&](VkCommandBuffer commands) { at = job.record(commands, at, budget, rates); }));
        ASSERT_LE(frames, told);
    }
    EXPECT_EQ(frames, told);
    EXPECT_EQ(stored(front, 0).texels, shown);
    EXPECT_EQ(std::memcmp(state.data(), whole.state.data(), state.size()), 0);
    for (std::size_t i = 0; i < images.size(); ++i)
        EXPECT_EQ(
            value_of(gpu.download(images[i], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL)).texels,
            stored(whole, i).texels)
            << "map " << i;

    // Piece by piece there are as many workgroups as in one go.
    const std::uint64_t pieces = Recorded::now().groups;
    Recorded::reset();
    value_of(
        gpu.submit([&](VkCommandBuffer commands) { job.record(commands, 0, plan.pass_count()); }));
    EXPECT_EQ(pieces, Recorded::now().groups);
    EXPECT_EQ(Recorded::now().dispatches, plan.pass_count());
}

TEST_F(PrefilterTest, MakesAtLeastAPieceAFrame) {
    const host::GpuImage source = on_device(gpu, even_cube(32, 1, 1, 1));
    const PrefilterPlan plan = plan_for({{64}}, 32);
    const std::vector<PassRate> rates = rates_for(plan);
    const std::vector<host::GpuImage> images = images_for(plan);
    const CubeMap map = cube_of(images[0]);
    const host::GpuBuffer scratch =
        storage(plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const host::GpuBuffer state = storage(plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const PrefilterJob job = value_of(
        prefilter.bind(plan, cube_of(source), {&map, 1}, scratch.handle(), state.handle()));
    EXPECT_GT(job.frames(0, rates), plan.pass_count());
    EXPECT_EQ(job.frames(1e9, rates), 1u);
    EXPECT_EQ(job.frames(0, {}), 1u); // of passes that nothing is known of, all
}

} // namespace
} // namespace lobelia::test
