#include <algorithm>

#include "furnace.h"
#include "support/some_of.h"

// What holds for every method that render() knows, by the path that the program takes.
namespace lobelia::test {
namespace {

class EveryMethod : public SphereTest, public testing::WithParamInterface<host::RenderMethod> {};

std::string test_name(const testing::TestParamInfo<host::RenderMethod>& info) {
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

TEST_P(EveryMethod, ShowsTheAlbedoInConstantLight) {
    // Samples show the specular lobe within their error only, which SphereImportanceTest knows.
    const float specular = GetParam().method == SphereMethod::importance ? 0.0f : 0.75f;
    const host::GpuEnvironment white = upload(even_panorama(2, 1, 1.0f, 1.0f, 1.0f));
    oracle::Random random(8);
    for (const float exponent : some_of({0.0f, 1.0f, 4.8f, 64.0f, 1e3f})) {
        const SphereView view{.camera = random_camera(random),
                              .material = grey(0.25f, specular, exponent),
                              .width = 16,
                              .height = 12};
        expect_furnace(draw(white, view, GetParam().method), view);
    }
}

TEST_P(EveryMethod, IsBlackWithoutReflectance) {
    const host::GpuEnvironment bright = upload(even_panorama(8, 4, 1e9f, 1e9f, 1e9f));
    const SphereView view{.background = false, .width = 16, .height = 16};
    const host::Image picture = draw(bright, view, GetParam().method);
    for (std::size_t i = 0; i < picture.texels.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(picture.texels[i + c], 0.0f);
}

TEST_P(EveryMethod, GivesFiniteTexelsOfEveryMaterial) {
    // Suns up to 1e9: what a material of kd + ks <= 1 sends on of it stays far from infinity.
    const host::GpuEnvironment suns =
        upload(image_of(oracle::random_cube(oracle::Scene::suns, 32, 9)));
    for (const Material& material :
         {grey(0.5f, 0.5f, 0.0f), grey(1e-38f, 0.5f, 1e6f), grey(0.5f, 1e-30f, 1e-30f)}) {
        const SphereView view{.material = material, .width = 7, .height = 5};
        for (const float value : draw(suns, view, GetParam().method).texels)
            ASSERT_TRUE(value >= 0.0f && value < 1e30f)
                << "kd " << material.diffuse[0] << " ks " << material.specular[0] << " n "
                << material.exponent << " gives " << value;
    }
}

INSTANTIATE_TEST_SUITE_P(Sphere, EveryMethod, testing::ValuesIn(host::render_methods()), test_name);

} // namespace
} // namespace lobelia::test
