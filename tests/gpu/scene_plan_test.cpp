#include <lobelia/expected_error.h>

#include <vulkan/vulkan.h>

#include "host/drawing.h"
#include "sphere_fixture.h"
#include "support/counting_device.h"
#include "support/some_of.h"

// Only what the scene calls for: what is recorded, counted, and pixels that stay as they are.
namespace lobelia::test {
namespace {

constexpr std::uint32_t SIZE = 40; // of pictures, pixels

class ScenePlanTest : public testing::Test {
protected:
    host::Gpu& gpu = counting_gpu();

    void TearDown() override {
        for (const std::string& message : gpu.take_messages()) ADD_FAILURE() << message;
    }

    static SphereView view_of(const Material& material, bool background = true) {
        return {.material = material, .background = background, .width = SIZE, .height = SIZE};
    }
    host::GpuEnvironment noise() {
        return upload(image_of(random_panorama(oracle::Scene::noise, 128, 64, 3)));
    }
    host::GpuEnvironment upload(const host::Image& image) {
        return value_of(host::upload_environment(gpu, image));
    }
    /// Renders, and checks that what was recorded is what the plan says.
    host::Rendering render(const host::GpuEnvironment& environment,
                           const host::RenderSettings& settings) {
        const ScenePlan plan = value_of(host::plan_scene(gpu, environment.cube.description().width,
                                                         environment.constant, settings));
        Recorded::reset();
        host::Rendering rendering = value_of(host::render(gpu, environment, settings));
        std::uint64_t planned = 0;
        for (const ScenePass& pass : plan.passes()) planned += pass.dispatches;
        EXPECT_EQ(Recorded::now().dispatches + Recorded::now().draws, planned);
        EXPECT_EQ(rendering.report.passes.size(), plan.passes().size());
        for (std::size_t i = 0; i < rendering.report.passes.size(); ++i) {
            const host::PassReport& ran = rendering.report.passes[i];
            const ScenePass& pass = plan.passes()[i];
            EXPECT_EQ(ran.name, pass.name);
            EXPECT_EQ(ran.invocations, pass.invocations) << ran.name;
            EXPECT_EQ(ran.bytes_read, pass.bytes_read) << ran.name;
            EXPECT_EQ(ran.bytes_written, pass.bytes_written) << ran.name;
        }
        return rendering;
    }
    /// The picture of `view` by maps and code for both lobes.
    host::Image unpruned(const host::GpuEnvironment& environment, const SphereView& view,
                         SphereMethod method) {
        host::RenderSettings all{.view = view, .method = method};
        all.view.material.diffuse = all.view.material.specular = {0.5f, 0.5f, 0.5f};
        const host::SphereInputs inputs =
            value_of(host::make_sphere_inputs(gpu, environment, all, {}));
        const host::Drawing drawing = value_of(host::Drawing::create(gpu, inputs, view));
        host::PassReport report;
        value_of(drawing.run(gpu, report));
        return value_of(drawing.picture(gpu));
    }

private:
    static host::Gpu& counting_gpu() {
        static host::Gpu one = value_of(host::Gpu::create(counting_options()));
        return one;
    }
};

const Material MATTE = grey(0.7f, 0, 64), SHINY = grey(0, 0.7f, 64), MIXED = grey(0.3f, 0.6f, 64);

TEST_F(ScenePlanTest, IsWhatEveryMethodRecords) {
    const host::GpuEnvironment environment = noise();
    for (const host::RenderMethod& method : host::render_methods()) {
        if (method.method == SphereMethod::reference) continue; // its averages are no passes
        for (const Material& material : {MATTE, SHINY, MIXED, grey(0, 0, 1)}) {
            SCOPED_TRACE(method.name);
            render(environment, {.view = view_of(material), .method = method.method});
        }
    }
}

TEST_F(ScenePlanTest, DropsALobeWithoutChangingAPixel) {
    const host::GpuEnvironment environment = noise();
    for (const SphereMethod method : {SphereMethod::split_sum, SphereMethod::two_tap})
        for (const Material& material : {MATTE, SHINY}) {
            const SphereView view = view_of(material);
            const host::Rendering pruned = render(environment, {.view = view, .method = method});
            EXPECT_EQ(pruned.picture.texels, unpruned(environment, view, method).texels)
                << "ks " << material.specular[0];
        }
}

TEST_F(ScenePlanTest, MakesNoMapForALobeThatIsBlack) {
    const auto plan = [&](const Material& material) {
        return value_of(host::plan_scene(gpu, 128, false, {.view = view_of(material)}));
    };
    EXPECT_EQ(plan(SHINY).prefilter()->maps().size(), 0u);
    EXPECT_EQ(plan(MATTE).prefilter()->ladder().rungs, 0u);
    EXPECT_FALSE(plan(MATTE).clipped_tables());
    EXPECT_EQ(plan(grey(0, 0, 64)).prefilter(), nullptr);
    EXPECT_LT(plan(MATTE).prefilter()->finest_level(), 128u);
    EXPECT_EQ(plan(grey(0, 1, 1e4f)).prefilter()->finest_level(), 128u);
}

TEST_F(ScenePlanTest, DropsTheBackgroundAlone) {
    const host::GpuEnvironment environment = noise();
    const host::Image with = render(environment, {.view = view_of(MIXED)}).picture;
    const host::Image without = render(environment, {.view = view_of(MIXED, false)}).picture;
    for (std::size_t i = 0; i < with.texels.size(); i += 4) {
        if (with.texels[i + 3] != 1.0f) continue; // covered wholly by the sphere
        for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(with.texels[i + c], without.texels[i + c]);
    }
}

TEST_F(ScenePlanTest, BlursTheBackgroundAlone) {
    const host::GpuEnvironment environment = noise();
    for (const Material& material : {MIXED, grey(0, 0, 1)})
        for (const SphereMethod method : {SphereMethod::kurt2019, SphereMethod::sh4,
                                          SphereMethod::split_sum, SphereMethod::two_tap}) {
            host::RenderSettings settings{.view = view_of(material), .method = method};
            const host::Image sharp = render(environment, settings).picture;
            settings.background_exponent = material.exponent; // split_sum has that map
            const host::Image blurred = render(environment, settings).picture;
            for (std::size_t i = 0; i < sharp.texels.size(); i += 4) {
                if (sharp.texels[i + 3] != 1.0f) continue; // covered wholly by the sphere
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_EQ(sharp.texels[i + c], blurred.texels[i + c]);
            }
        }
}

// The six axes, to which the texels of a cube map of one texel a face belong.
TEST_F(ScenePlanTest, BlursTheBackgroundByItsLobe) {
    const host::GpuEnvironment environment =
        upload(image_of(random_panorama(oracle::Scene::suns, 128, 64, 3)));
    const std::array<float, 3> axes[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                         {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    for (const float exponent : some_of({1.0f, 16.0f, 300.0f})) {
        const auto exact = [&](float n) {
            return value_of(
                       host::prefilter(
                           gpu, environment,
                           {.method = host::PrefilterMethod::exact, .exponents = {n}, .width = 1}))
                .maps.front()
                .texels;
        };
        // An axis lies between four texels of the face. Their mean adds a quarter of a squared
        // texel to the lobe's variance, of which they have 2.8 to a standard deviation or more.
        const auto truth = exact(exponent), wider = exact(exponent / (1 + 0.25f / (2.8f * 2.8f)));
        const double promised = expected_map_error(Quality::normal, exponent, 32);
        for (std::size_t face = 0; face < 6; ++face) {
            const auto& axis = axes[face];
            SphereView view{.camera = {.eye = {4 * axis[0], 4 * axis[1], 4 * axis[2]},
                                       .target = {9 * axis[0], 9 * axis[1], 9 * axis[2]},
                                       .up = {axis[1], axis[2], axis[0]}},
                            .width = 1,
                            .height = 1};
            const host::Image picture =
                render(environment, {.view = view, .background_exponent = exponent}).picture;
            for (std::size_t c = 0; c < 3; ++c) {
                const double expected = truth[4 * face + c];
                EXPECT_NEAR(picture.texels[c], expected,
                            2 * std::abs(double(wider[4 * face + c]) - expected) +
                                promised * expected)
                    << "n " << exponent << ", face " << face;
            }
        }
    }
}

TEST_F(ScenePlanTest, DropsSunsThatAreNotThere) {
    const host::GpuEnvironment environment = noise();
    host::SphereInputs inputs =
        value_of(host::make_sphere_inputs(gpu, environment, {.view = view_of(MIXED)}, {}));
    ASSERT_EQ(inputs.report.suns, 0u);
    EXPECT_FALSE(inputs.shading.suns);
    const host::Image pruned = render(environment, {.view = view_of(MIXED)}).picture;
    inputs.shading.suns = true;
    const host::Drawing drawing = value_of(host::Drawing::create(gpu, inputs, view_of(MIXED)));
    host::PassReport report;
    value_of(drawing.run(gpu, report));
    EXPECT_EQ(pruned.texels, value_of(drawing.picture(gpu)).texels);
}

TEST_F(ScenePlanTest, MakesNoMapsOfAConstantEnvironment) {
    host::GpuEnvironment environment = upload(even_panorama(64, 32, 0.5f, 1.0f, 2.0f));
    ASSERT_TRUE(environment.constant);
    for (const SphereMethod method : {SphereMethod::split_sum, SphereMethod::two_tap}) {
        const host::Rendering direct =
            render(environment, {.view = view_of(MIXED), .method = method});
        EXPECT_EQ(direct.report.passes.size(), 1u);
        environment.constant = false;
        const host::Image mapped =
            render(environment, {.view = view_of(MIXED), .method = method}).picture;
        environment.constant = true;
        // These colours are halves; what is left are sums of weights in 32 bits.
        for (std::size_t i = 0; i < mapped.texels.size(); ++i)
            ASSERT_NEAR(direct.picture.texels[i], mapped.texels[i], 1e-5f * 2);
    }
}

TEST_F(ScenePlanTest, DrawsNoSphereThatIsOutOfThePicture) {
    const host::GpuEnvironment environment = noise();
    SphereView view = view_of(MIXED);
    view.camera.target = {0, 0, 9}; // away from it
    const host::Rendering background = render(environment, {.view = view});
    EXPECT_EQ(background.report.passes.size(), 1u);
    view.background = false;
    const host::Rendering nothing = render(environment, {.view = view});
    EXPECT_EQ(nothing.report.passes.size(), 0u);
    for (const float value : nothing.picture.texels) ASSERT_EQ(value, 0.0f);
    // To the side of it, where the silhouette just is not seen and just is.
    view.camera.target = {4.0f, 0, 0};
    EXPECT_EQ(render(environment, {.view = view}).report.passes.size(), 0u);
    view.camera.target = {1.5f, 0, 0};
    EXPECT_GT(render(environment, {.view = view}).report.passes.size(), 1u);
}

TEST_F(ScenePlanTest, SharesLevelsBetweenMaterials) {
    const auto levels = [](std::span<const SceneMaterial> materials) {
        const ScenePlan plan = value_of(ScenePlan::make(
            {.materials = materials, .source_size = 256, .width = SIZE, .height = SIZE}));
        return plan.prefilter()->first_map_pass();
    };
    const std::array<float, 3> grey{0.5f, 0.5f, 0.5f};
    const SceneMaterial materials[] = {
        {grey, grey, 500, 500}, {grey, grey, 64, 64}, {grey, {}, 1, 1}, {grey, grey, 100, 400}};
    const std::uint32_t sharpest = levels({materials, 1}), deepest = levels({materials + 1, 1});
    const std::uint32_t both = levels({materials, 2});
    EXPECT_GE(both, std::max(sharpest, deepest));
    EXPECT_LT(both, sharpest + deepest);
    EXPECT_EQ(levels(materials), both); // what lies between them finds all its levels there
}

TEST(SceneEditTest, AsksForNoMoreThanItChanges) {
    const auto plan = [](float kd, float ks, float n, bool background = true) {
        const SceneMaterial material{{kd, kd, kd}, {ks, ks, ks}, n, n};
        return value_of(ScenePlan::make({.materials = {&material, 1},
                                         .background = background,
                                         .source_size = 256,
                                         .width = SIZE,
                                         .height = SIZE,
                                         .levels_up_to = 1e5f}));
    };
    using Maps = SceneEdit::Maps;
    const ScenePlan before = plan(0.3f, 0.6f, 64);
    const auto edit = [&](const ScenePlan& after) { return edit_between(before, after); };
    EXPECT_EQ(edit(plan(0.1f, 0.2f, 64)).maps, Maps::kept);
    EXPECT_FALSE(edit(plan(0.1f, 0.2f, 64)).shading);
    EXPECT_EQ(edit(plan(0, 0.2f, 64)).maps, Maps::kept); // a map too many is none too few
    EXPECT_TRUE(edit(plan(0, 0.2f, 64)).shading);
    EXPECT_EQ(edit(plan(0.3f, 0.6f, 64, false)).maps, Maps::kept);
    EXPECT_TRUE(edit(plan(0.3f, 0.6f, 64, false)).shading);
    for (const float n : {0.0f, 16.0f, 1000.0f}) {
        EXPECT_EQ(edit(plan(0.3f, 0.6f, n)).maps, Maps::from_levels) << n;
        EXPECT_FALSE(edit(plan(0.3f, 0.6f, n)).shading) << n;
    }
    EXPECT_EQ(edit_between(plan(0.3f, 0, 64), before).maps, Maps::from_levels);
    EXPECT_EQ(edit_between(plan(0, 0, 64), before).maps, Maps::anew);
}

TEST(SceneEditTest, OfTheBackgroundsBlurComesFromTheLevels) {
    const SceneMaterial material{{}, {1, 1, 1}, 64, 64};
    const auto plan = [&](float blur) {
        return value_of(ScenePlan::make({.materials = {&material, 1},
                                         .background_exponent = blur,
                                         .method = SphereMethod::split_sum,
                                         .source_size = 256,
                                         .width = SIZE,
                                         .height = SIZE,
                                         .levels_up_to = 1e5f}));
    };
    using Maps = SceneEdit::Maps;
    const ScenePlan sharp = plan(std::numeric_limits<float>::infinity());
    EXPECT_EQ(edit_between(plan(8), plan(8)).maps, Maps::kept);
    EXPECT_EQ(edit_between(plan(8), sharp).maps, Maps::kept);
    for (const float blur : {8.0f, 64.0f})
        for (const ScenePlan& before : {sharp, plan(9)})
            EXPECT_EQ(edit_between(before, plan(blur)).maps, Maps::from_levels) << blur;
}

TEST(SceneEditTest, IsRefusedWhereTheMethodHasNoLadder) {
    const SceneMaterial material{{}, {1, 1, 1}, 8, 64};
    const auto refused = ScenePlan::make({.materials = {&material, 1},
                                          .method = SphereMethod::split_sum,
                                          .source_size = 64,
                                          .width = SIZE,
                                          .height = SIZE});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, VK_ERROR_VALIDATION_FAILED_EXT);
}

} // namespace
} // namespace lobelia::test
