#include "sphere_fixture.h"

// What a program asks of the host: maps and their places, reports, progress, refusals.
namespace lobelia::test {
namespace {

class WorkTest : public SphereTest {};

std::vector<oracle::Direction> map_directions(const host::Image& map) {
    const oracle::Source source = source_of(map);
    std::vector<oracle::Direction> directions;
    for (int layer = 0; layer < source.layers(); ++layer)
        for (int y = 0; y < source.height(); ++y)
            for (int x = 0; x < source.width(); ++x)
                directions.push_back(source.direction(layer, x, y));
    return directions;
}

TEST_F(WorkTest, PrefiltersIntoEitherLayout) {
    const oracle::Source source = random_panorama(oracle::Scene::noise, 16, 8, 4);
    const host::GpuEnvironment environment = upload(image_of(source));
    for (const host::Layout layout : {host::Layout::cube, host::Layout::latlong}) {
        const auto filtered = value_of(host::prefilter(gpu, environment,
                                                       {.method = host::PrefilterMethod::exact,
                                                        .exponents = {1.0f, 16.0f},
                                                        .layout = layout,
                                                        .width = 8}));
        ASSERT_EQ(filtered.maps.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            const host::Image& map = filtered.maps[i];
            EXPECT_EQ(map.layout, layout);
            EXPECT_EQ(map.width, 8u);
            EXPECT_EQ(map.height, layout == host::Layout::cube ? 8u : 4u);
            const auto truth = lobe_averages(source, map_directions(map), i == 0 ? 1.0 : 16.0);
            for (std::size_t t = 0; t < truth.size(); ++t)
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(map.texels[4 * t + c] / truth[t][c], 1.0, 1e-4)
                        << "map " << i << " texel " << t << " channel " << c;
        }
    }
}

TEST_F(WorkTest, TakesACubeAsItIs) {
    const oracle::Source source = random_cube(oracle::Scene::noise, 8, 4);
    const host::GpuEnvironment environment = upload(image_of(source));
    EXPECT_FALSE(environment.panorama);
    const auto filtered = value_of(
        host::prefilter(gpu, environment,
                        {.method = host::PrefilterMethod::exact, .exponents = {4.0f}, .width = 4}));
    const auto truth = lobe_averages(source, map_directions(filtered.maps[0]), 4.0);
    for (std::size_t t = 0; t < truth.size(); ++t)
        ASSERT_NEAR(filtered.maps[0].texels[4 * t] / truth[t][0], 1.0, 1e-4) << "texel " << t;
}

TEST_F(WorkTest, ReportsWhatItDid) {
    const host::GpuEnvironment environment = upload(even_panorama(64, 32, 1.0f, 1.0f, 1.0f));
    ASSERT_EQ(environment.report.passes.size(), 1u);
    EXPECT_EQ(environment.report.passes[0].bytes_read, 64u * 32 * 16);
    EXPECT_EQ(environment.report.passes[0].bytes_written, 6u * 16 * 16 * 16);

    const SphereView view{.material = grey(0.5f, 0.5f, 4.0f), .width = 10, .height = 8};
    const auto rendering = value_of(host::render(gpu, environment, {.view = view}));
    std::string names;
    for (const host::PassReport& pass : rendering.report.passes) names += pass.name + ";";
    EXPECT_EQ(
        names,
        "statistics;suns;prepare;suns "
        "out;margins;project;sum;expand;expand;expand;expand;expand;expand;clipped tables;sphere;");
    EXPECT_EQ(rendering.report.passes.back().invocations, 80u);
    EXPECT_EQ(rendering.report.passes.back().bytes_written, 80u * 16);
}

TEST_F(WorkTest, TimesEveryPassByTheDevicesClockToo) {
    const host::GpuEnvironment environment = upload(even_panorama(64, 32, 1.0f, 1.0f, 1.0f));
    const SphereView view{.material = grey(0.5f, 0.5f, 4.0f), .width = 10, .height = 8};
    const auto rendering = value_of(host::render(gpu, environment, {.view = view}));
    for (const host::PassReport& pass : rendering.report.passes) {
        EXPECT_GE(pass.cpu_ms.value_or(-1.0), 0.0) << pass.name;
        EXPECT_GT(pass.gpu_ms.value_or(-1.0), 0.0) << pass.name;
    }
}

TEST_F(WorkTest, SamplesFromMips) {
    const host::GpuEnvironment environment = upload(even_panorama(64, 32, 1.0f, 2.0f, 3.0f));
    for (const bool filtered : {false, true}) {
        const auto sampled = value_of(
            host::prefilter(gpu, environment,
                            {.method = filtered ? host::PrefilterMethod::filtered_importance
                                                : host::PrefilterMethod::importance,
                             .samples = 600,
                             .exponents = {1.0f, 64.0f},
                             .width = 4}));
        ASSERT_EQ(sampled.maps.size(), 2u);
        for (const host::Image& map : sampled.maps) {
            ASSERT_EQ(map.texels.size(), 6u * 4 * 4 * 4);
            for (std::size_t i = 0; i < map.texels.size(); ++i) // 1 2 3 1, to a sum's roundings
                ASSERT_NEAR(map.texels[i], i % 4 == 3 ? 1.0f : float(i % 4 + 1), 1e-4f);
        }
        ASSERT_EQ(sampled.report.passes.size(), 3u);
        EXPECT_EQ(sampled.report.passes[0].name, "mips");
        EXPECT_EQ(sampled.report.passes[1].name, filtered ? "filtered importance" : "importance");
        EXPECT_EQ(sampled.report.passes[2].invocations, 6u * 4 * 4);
        ASSERT_EQ(sampled.report.images.size(), 1u);
        const host::ImageReport& mips = sampled.report.images[0];
        EXPECT_EQ(mips.levels, filtered ? 5u : 1u);
        EXPECT_EQ(mips.bytes, 16u * 6 * (filtered ? 256 + 64 + 16 + 4 + 1 : 256));
        EXPECT_EQ(sampled.report.passes[0].bytes_written, mips.bytes);
    }
}

TEST_F(WorkTest, MakesALargerCubeMapForHighQuality) {
    const host::Image image = even_panorama(64, 32, 1.0f, 1.0f, 1.0f);
    const auto face = [&](Quality quality) {
        return value_of(host::upload_environment(gpu, image, 0, quality)).cube.description().width;
    };
    EXPECT_EQ(face(Quality::normal), 16u);
    EXPECT_EQ(face(Quality::high), 32u);
}

TEST_F(WorkTest, StopsWhenToldTo) {
    const host::GpuEnvironment environment = upload(even_panorama(64, 32, 1.0f, 1.0f, 1.0f));
    const SphereView view{.material = grey(0.5f, 0.5f, 4.0f), .width = 10, .height = 8};
    for (const auto& [method, name, what] : host::render_methods()) {
        double last = -1.0;
        const auto stopped =
            host::render(gpu, environment, {.view = view, .method = method}, [&](double done) {
                EXPECT_GE(done, last);
                EXPECT_LE(done, 1.0);
                last = done;
                return false;
            });
        ASSERT_FALSE(stopped) << name;
        EXPECT_EQ(stopped.error().message, "cancelled");
    }
}

TEST_F(WorkTest, RefusesWhatIsNoEnvironment) {
    host::Image broken = even_panorama(4, 2, 1.0f, 1.0f, 1.0f);
    broken.texels.pop_back();
    const auto uploaded = host::upload_environment(gpu, broken);
    ASSERT_FALSE(uploaded);
    EXPECT_EQ(uploaded.error().message,
              "an environment is one panorama or six square faces of R G B A texels");

    const host::GpuEnvironment environment = upload(even_panorama(4, 2, 1.0f, 1.0f, 1.0f));
    EXPECT_FALSE(host::prefilter(gpu, environment, {}));
    EXPECT_FALSE(host::prefilter(gpu, environment, {.exponents = {-1.0f}}));
    EXPECT_FALSE(host::prefilter(gpu, environment, {.exponents = {1.0f}, .width = 20000}));
    EXPECT_FALSE(host::prefilter(gpu, environment, {.samples = 0, .exponents = {1.0f}}));
    EXPECT_FALSE(host::prefilter(
        gpu, environment, {.exponents = {1.0f}, .layout = host::Layout::latlong, .levels = true}));
    EXPECT_FALSE(host::prefilter(gpu, environment,
                                 {.exponents = {4.0f, 2.0f, 1.0f}, .width = 2, .levels = true}));
}

} // namespace
} // namespace lobelia::test
