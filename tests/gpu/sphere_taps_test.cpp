#include <cmath>

#include "sphere_fixture.h"
#include "support/error_measures.h"
#include "support/some_of.h"

// The lobe that the horizon cuts, by few fetches, against `reference`.
namespace lobelia::test {
namespace {

constexpr SphereMethod TAPS[] = {SphereMethod::one_tap, SphereMethod::two_tap,
                                 SphereMethod::hybrid};

class TapsTest : public SphereTest {
protected:
    /// Pointwise RMS of what the sphere shows, where it fills its pixel.
    double error(const host::Image& truth, const host::GpuEnvironment& environment,
                 const SphereView& view, SphereMethod method) {
        const host::Image shown = draw(environment, view, method);
        std::vector<double> expected, got;
        for (std::size_t i = 0; i < truth.texels.size(); i += 4)
            for (std::size_t c = 0; c < 3 && truth.texels[i + 3] == 1.0f; ++c) {
                expected.push_back(double(truth.texels[i + c]));
                got.push_back(double(shown.texels[i + c]));
            }
        return oracle::measure_error(got, expected).pointwise_rms;
    }
};

SphereView gloss(float exponent) {
    return {.material = {.specular = {1, 1, 1}, .exponent = exponent},
            .background = false,
            .width = 16,
            .height = 16};
}

TEST_F(TapsTest, AreExactInLinearLight) {
    // All have the lobe's mean direction. What is left: halves (5e-4 of the light), the table's
    // steps (1e-3 lobe widths, and 1.5e-3 of a variance) times the light's slope of 0.54, and the
    // texels' own steps, a 48th of the square of their width.
    const host::GpuEnvironment environment =
        upload(image_of(oracle::panorama_of(64, 32, [](const oracle::Direction& d) {
            const double light = 1 + 0.4 * d.x - 0.3 * d.y + 0.2 * d.z;
            return oracle::Rgb{light, light, light};
        })));
    for (const float exponent : some_of({1.0f, 64.0f})) {
        const SphereView view = gloss(exponent);
        const host::Image truth = draw(environment, view, SphereMethod::reference);
        for (const SphereMethod method : TAPS)
            EXPECT_LE(error(truth, environment, view, method), 2e-3)
                << "n " << exponent << " method " << int(method);
    }
}

TEST_F(TapsTest, EachTapMoreIsNearerToTheTruth) {
    // Half a sky: the hardest light for a lobe that the horizon cuts.
    const host::GpuEnvironment environment =
        upload(image_of(oracle::random_panorama(oracle::Scene::halves, 64, 32, 5)));
    for (const float exponent : some_of({16.0f, 64.0f})) {
        const SphereView view = gloss(exponent);
        const host::Image truth = draw(environment, view, SphereMethod::reference);
        double before = error(truth, environment, view, SphereMethod::split_sum);
        for (const SphereMethod method : TAPS) {
            const double now = error(truth, environment, view, method);
            EXPECT_LT(now, before) << "n " << exponent << " method " << int(method);
            before = now;
        }
    }
}

TEST_F(TapsTest, KeepSunsAndTheirHorizon) {
    // One texel of light, of a cube map, since a panorama's would move by part of a texel on the
    // way to one. The taps add it as a lobe of the same variance, v = 5e-5, with the cosine of its
    // middle. That differs from the texel's integral by (v n)^2 He_4(3) / 24 within three lobe
    // widths, 1e-4 here, and on the horizon, in one pixel of a hundred, by an eighth of the texel's
    // width of 0.025 against the cosines of half that around it: 2e-3 in all.
    std::vector<oracle::Rgb> texels(6 * 64 * 64, oracle::Rgb{0.5, 0.5, 0.5});
    texels[4 * 64 * 64 + 20 * 64 + 45] = {3e4, 2e4, 1e4};
    const host::GpuEnvironment environment = upload(image_of(oracle::Source::cube(64, texels)));
    const SphereView view = gloss(30.0f);
    const host::Image truth = draw(environment, view, SphereMethod::reference);
    for (const SphereMethod method : TAPS)
        EXPECT_LE(error(truth, environment, view, method), 2e-3) << "method " << int(method);
}

} // namespace
} // namespace lobelia::test
