#include "sphere_fixture.h"

#include "support/error_measures.h"
#include "support/parallel.h"
#include "support/real_panoramas.h"
#include "support/some_of.h"

// The reference picture against an integration in double precision that shares no text with it: to
// the 1e-4 that each average is good for.
namespace lobelia::test {
namespace {

class SphereReferenceTest : public SphereTest {
protected:
    // Root mean square of the difference over the sphere's pixels, relative to that of the truth.
    double relative_error(const host::Image& picture, const SphereView& view,
                          const oracle::Source& truth) {
        const oracle::Camera camera = oracle_camera(view);
        const auto& [kd, ks, exponent] = view.material;
        const oracle::Material material{{kd[0], kd[1], kd[2]}, {ks[0], ks[1], ks[2]}, exponent};
        std::vector<std::uint32_t> pixels;
        for (std::uint32_t i = 0; i < view.width * view.height; ++i)
            if (picture.texels[4 * i + 3] == 1.0f) pixels.push_back(i);
        std::vector<oracle::Rgb> exact(pixels.size());
        oracle::parallel_for(pixels.size(), [&](std::size_t i) {
            const oracle::Direction along =
                ray(camera, pixels[i] % view.width + 0.5, pixels[i] / view.width + 0.5);
            const auto hit = oracle::meet_sphere(camera.eye, along);
            exact[i] = shade(truth, hit->normal, hit->view, material);
        });
        std::vector<float> actual;
        std::vector<double> expected;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                actual.push_back(picture.texels[4 * pixels[i] + c]);
                expected.push_back(exact[i][c]);
            }
        EXPECT_GT(pixels.size(), 15u);
        return oracle::measure_error(actual, expected).image_rms;
    }
};

TEST_F(SphereReferenceTest, IsTheTruth) {
    if (!has_real_panoramas()) GTEST_SKIP() << "no panoramas in " LOBELIA_PANORAMAS;
    const Material materials[] = {
        grey(1.0f, 0.0f, 1.0f),  grey(0.0f, 1.0f, 1.0f),  grey(0.0f, 1.0f, 4.8f),
        grey(0.0f, 1.0f, 16.0f), grey(0.0f, 1.0f, 64.0f), grey(0.3f, 0.6f, 64.0f),
    };
    const std::array<float, 3> eyes[] = {{0, 0, 4}, {-4, 0, 0}, {1, 3, -2}, {2, -1, 2}};
    int next_eye = 0;
    for (const std::string name : some_of({"city", "interior"})) {
        const host::Image image = real_panorama(name);
        const host::GpuEnvironment environment = upload(image);
        const oracle::Source truth = source_of(image);
        for (const Material& material : some_of(materials)) {
            const SphereView view{.camera = {.eye = eyes[next_eye++ % 4]},
                                  .material = material,
                                  .background = false,
                                  .width = 7,
                                  .height = 7};
            const host::Image picture = draw(environment, view, SphereMethod::reference);
            const double error = relative_error(picture, view, truth);
            EXPECT_LE(error, 1e-4)
                << name << " kd " << material.diffuse[0] << " ks " << material.specular[0] << " n "
                << material.exponent << " " << text(view.camera);
        }
    }
}

} // namespace
} // namespace lobelia::test
