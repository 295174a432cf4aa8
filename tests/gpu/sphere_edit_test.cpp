#include <cstring>

#include <lobelia/clipped_tables.h>

#include <vulkan/vulkan.h>

#include "host/maps.h"
#include "host/sphere_inputs.h"
#include "sphere_fixture.h"
#include "support/counting_device.h"

// What an edit of the material, and another view in the same frame, record. Every dispatch and draw
// of this device is counted.
namespace lobelia::test {
namespace {

constexpr float LEAST = 1.0f, MOST = 1024.0f; // exponents of the ladder

struct TapsMethod {
    SphereMethod method;
    Taps taps;
};
constexpr TapsMethod TAPS_METHODS[] = {{SphereMethod::two_tap, Taps::two},
                                       {SphereMethod::hybrid, Taps::five}};

/// A sphere lit by maps on a ladder, as an engine keeps it from frame to frame.
struct Scene {
    host::PrefilteredMaps maps;
    host::GpuImage tables;
    SphereSources sources;
};

class SphereEditTest : public testing::Test {
protected:
    host::Gpu gpu = value_of(host::Gpu::create(counting_options()));
    host::GpuEnvironment light = value_of(host::upload_environment(
        gpu, image_of(oracle::random_panorama(oracle::Scene::suns, 64, 32, 5))));

    void TearDown() override {
        for (const std::string& message : gpu.take_messages()) ADD_FAILURE() << message;
    }

    Scene make_scene(Taps taps) {
        const PrefilterPlan plan =
            value_of(PrefilterPlan::make({.lambert = true,
                                          .ladder = ladder_for(taps, LEAST, MOST),
                                          .source_size = light.cube.description().width}));
        host::PassReport upload;
        Scene scene{value_of(host::make_maps(gpu, light, plan, {})),
                    value_of(host::make_clipped_tables(gpu, upload)),
                    {}};
        scene.sources = {.background = light.cube.view(),
                         .diffuse = scene.maps.images.back().view(),
                         .prefilter_state = scene.maps.state.handle(),
                         .ladder = scene.maps.ladder->view(),
                         .clipped_tables = scene.tables.view()};
        return scene;
    }
};

void expect_same_bits(const host::Image& one, const host::Image& other) {
    ASSERT_EQ(one.texels.size(), other.texels.size());
    EXPECT_EQ(
        std::memcmp(one.texels.data(), other.texels.data(), one.texels.size() * sizeof(float)), 0);
}

TEST_F(SphereEditTest, OfAnyMaterialWithinTheLadderRecordsTheSphereAlone) {
    const Material edits[] = {grey(0.3f, 0.6f, 64.0f),  grey(0.4f, 0.6f, 64.0f),
                              grey(0.5f, 0.1f, 64.0f),  grey(0.5f, 0.1f, LEAST),
                              grey(0.5f, 0.1f, 300.5f), grey(0.5f, 0.1f, MOST)};
    for (const auto& [method, taps] : TAPS_METHODS) {
        Recorded::reset();
        const Scene scene = make_scene(taps);
        EXPECT_GT(Recorded::now().dispatches, 10u); // so they are counted
        const SpherePicture picture(gpu, 24, 16, {.method = method});
        const Scene anew = make_scene(taps);
        for (const Material& material : edits) {
            SCOPED_TRACE("n " + std::to_string(material.exponent));
            Recorded::reset();
            const SphereView view{.material = material, .width = 24, .height = 16};
            const host::Image edited = picture.draw(scene.sources, view);
            EXPECT_EQ(Recorded::now().dispatches, 0u);
            EXPECT_EQ(Recorded::now().draws, 1u);
            // Nothing that was not recorded is missing: all made anew shows the same.
            expect_same_bits(
                edited, SpherePicture(gpu, 24, 16, {.method = method}).draw(anew.sources, view));
        }
    }
}

TEST_F(SphereEditTest, NeedsNothingElseByOtherMethodsEither) {
    const Material before = grey(0.3f, 0.6f, 64.0f);
    const Material colours{{0.1f, 0.5f, 0.9f}, {0.8f, 0.2f, 0.1f}, 64.0f};
    const Material all{colours.diffuse, colours.specular, 5.0f};
    for (const auto& [method, after] :
         {std::pair{SphereMethod::split_sum, colours}, std::pair{SphereMethod::kurt2019, all},
          std::pair{SphereMethod::importance, all}}) {
        SCOPED_TRACE(int(method));
        host::RenderSettings settings{.view = {.material = before, .width = 24, .height = 16},
                                      .method = method};
        const auto inputs_now = [&] {
            return value_of(host::make_sphere_inputs(gpu, light, settings, {}));
        };
        const host::SphereInputs inputs = inputs_now();
        const SpherePicture picture(gpu, 24, 16, inputs.shading);
        settings.view.material = after;
        Recorded::reset();
        const host::Image edited = picture.draw(inputs.sources, settings.view);
        EXPECT_EQ(Recorded::now().dispatches, 0u);
        EXPECT_EQ(Recorded::now().draws, 1u);
        const host::SphereInputs anew = inputs_now();
        expect_same_bits(edited, picture.draw(anew.sources, settings.view));
    }
}

// Another environment is other descriptors, and a blend of two the blend of their pictures.
TEST_F(SphereEditTest, SwitchingAndBlendingEnvironmentsRecordsTheSphereAlone) {
    const oracle::Source one = oracle::random_panorama(oracle::Scene::smooth, 64, 32, 6);
    const oracle::Source other = oracle::random_panorama(oracle::Scene::smooth, 64, 32, 7);
    std::vector<oracle::Rgb> sums;
    for (std::size_t i = 0; i < one.texels().size(); ++i)
        sums.push_back({0.25 * one.texels()[i][0] + 0.75 * other.texels()[i][0],
                        0.25 * one.texels()[i][1] + 0.75 * other.texels()[i][1],
                        0.25 * one.texels()[i][2] + 0.75 * other.texels()[i][2]});
    const oracle::Source both = oracle::Source::panorama(64, 32, std::move(sums));

    const host::RenderSettings settings{
        .view = {.material = grey(0.3f, 0.6f, 64.0f), .width = 24, .height = 16}};
    std::vector<host::GpuEnvironment> environments;
    std::vector<host::SphereInputs> inputs;
    for (const oracle::Source& source : {one, other, both}) {
        environments.push_back(value_of(host::upload_environment(gpu, image_of(source))));
        inputs.push_back(
            value_of(host::make_sphere_inputs(gpu, environments.back(), settings, {})));
    }
    const SpherePicture picture(gpu, 24, 16, inputs[0].shading);
    Recorded::reset();
    std::vector<std::vector<float>> shown;
    for (const host::SphereInputs& input : inputs)
        shown.push_back(picture.draw(input.sources, settings.view).texels);
    EXPECT_EQ(Recorded::now().dispatches, 0u);
    EXPECT_EQ(Recorded::now().draws, 3u);
    // All from the light to the pixel is linear but for rounding to halves, of a level and of a
    // map, in each of three pictures.
    constexpr double ROUNDING = 3 * 2 * 0x1p-11;
    for (std::size_t i = 0; i < shown[2].size(); ++i)
        ASSERT_NEAR(0.25f * shown[0][i] + 0.75f * shown[1][i], shown[2][i],
                    ROUNDING * double(shown[2][i]))
            << i;
}

TEST_F(SphereEditTest, SeveralViewsOfOneSceneShareAFrame) {
    const Scene scene = make_scene(Taps::two);
    SphereView left{.camera = {.eye = {-4, 0, 0.1f}},
                    .material = grey(0.2f, 0.7f, 20.0f),
                    .width = 24,
                    .height = 16};
    SphereView right{.camera = {.eye = {2, 3, 0}, .vertical_field_of_view = 50},
                     .material = grey(0.9f, 0.1f, 500.0f),
                     .environment_rotation = 1.0f,
                     .width = 20,
                     .height = 30};
    const SphereShading shading{.method = SphereMethod::two_tap};
    const auto first = value_of(host::ColourTarget::create(gpu, left.width, left.height));
    const auto second = value_of(host::ColourTarget::create(gpu, right.width, right.height));
    const Sphere sphere =
        value_of(Sphere::create(gpu.device(), {.render_pass = first.render_pass()}, shading));
    const SphereJob job = value_of(sphere.bind(scene.sources));
    value_of(gpu.submit([&](VkCommandBuffer commands) { // one pipeline, one job, one submission
        first.record(commands, [&](VkCommandBuffer inside) { job.record(inside, left); });
        second.record(commands, [&](VkCommandBuffer inside) { job.record(inside, right); });
    }));
    for (const auto& [target, view] : {std::pair{&first, &left}, std::pair{&second, &right}})
        expect_same_bits(
            value_of(gpu.download(target->image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)),
            SpherePicture(gpu, view->width, view->height, shading).draw(scene.sources, *view));
}

} // namespace
} // namespace lobelia::test
