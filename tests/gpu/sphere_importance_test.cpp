#include "sphere_fixture.h"
#include "support/sampled.h"

// Filtered importance sampling in the sphere's shader: what it converges to, and how fast.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;

/// A pixel that the sphere covers wholly.
struct Point {
    std::size_t pixel;
    Direction normal;
    Direction mirror;
    double cosine;
};

/// Mean square over a lobe's samples of what one of them adds in constant light,
/// (n + 2) / (n + 1) max(0, N . w): a sum over the middles of equal parts of share and turn.
double mean_square_weight(double cosine, double n) {
    constexpr int PARTS = 200;
    const double factor = (n + 2) / (n + 1), sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    double sum = 0;
    for (int i = 0; i < PARTS; ++i) {
        const double along = std::pow((i + 0.5) / PARTS, 1 / (n + 1));
        const double across = std::sqrt(1 - along * along);
        for (int j = 0; j < PARTS; ++j) {
            const double turn = oracle::PI * (j + 0.5) / PARTS; // the other half mirrors it
            const double weight =
                factor * std::max(cosine * along + sine * across * std::cos(turn), 0.0);
            sum += weight * weight;
        }
    }
    return sum / (PARTS * PARTS);
}

class SphereImportanceTest : public SphereTest {
protected:
    host::Image draw_samples(const host::GpuEnvironment& environment, const SphereView& view,
                             std::uint32_t samples) {
        return value_of(host::render(
                            gpu, environment,
                            {.view = view, .method = SphereMethod::importance, .samples = samples}))
            .picture;
    }

    std::vector<Point> points(const host::Image& picture, const SphereView& view) {
        const oracle::Camera camera = oracle_camera(view);
        std::vector<Point> found;
        for (std::uint32_t i = 0; i < view.width * view.height; ++i) {
            const auto hit = oracle::meet_sphere(
                camera.eye, ray(camera, i % view.width + 0.5, i / view.width + 0.5));
            if (!hit || picture.texels[4 * std::size_t(i) + 3] < 1.0f) continue;
            found.push_back({4 * std::size_t(i), hit->normal,
                             oracle::mirror(hit->normal, hit->view), dot(hit->normal, hit->view)});
        }
        EXPECT_GT(found.size(), 100u);
        return found;
    }
};

TEST_F(SphereImportanceTest, ShowsTheAlbedoInConstantLightWithinTheSamplingError) {
    const host::GpuEnvironment white = upload(even_panorama(2, 1, 1.0f, 1.0f, 1.0f));
    SphereView view{.width = 16, .height = 16};
    for (const float exponent : {0.0f, 1.0f, 4.8f, 64.0f, 1e4f}) {
        const double n = double(exponent);
        view.material = grey(0.25f, 0.75f, exponent);
        double before = 0;
        for (const std::uint32_t samples : {4u, 16u, 64u, 256u, 1024u}) {
            const host::Image picture = draw_samples(white, view, samples);
            double squares = 0, variances = 0;
            const std::vector<Point> compared = points(picture, view);
            for (const Point& point : compared) {
                const double albedo = oracle::albedo(point.cosine, n);
                const double error = double(picture.texels[point.pixel]) - 0.25 - 0.75 * albedo;
                squares += error * error;
                variances +=
                    0.75 * 0.75 * (mean_square_weight(point.cosine, n) - albedo * albedo) / samples;
            }
            // Points in strata are at least as good as random ones, and better by more from one
            // number to the next than these are, but for rounding.
            const double count = double(compared.size()), rounding = 2e-6;
            const double error = std::sqrt(squares / count);
            EXPECT_LE(error, std::sqrt(std::max(variances, 0.0) / count) + rounding)
                << "n " << n << " N " << samples;
            if (before > 0) {
                EXPECT_LE(error, before / 2 + rounding) << "n " << n << " N " << samples;
            }
            before = error;
        }
    }
}

TEST_F(SphereImportanceTest, AveragesTheDiffuseLobeAsImportanceDoes) {
    const auto source = oracle::random_cube(oracle::Scene::smooth, 32, 4);
    const host::GpuEnvironment environment = upload(image_of(source));
    const SphereView view{.camera = {.eye = {2, 3, -1}},
                          .material = grey(1.0f, 0.0f, 1.0f),
                          .width = 16,
                          .height = 16};
    for (const std::uint32_t samples : {1u, 32u}) {
        const host::Image picture = draw_samples(environment, view, samples);
        std::vector<Direction> normals;
        const std::vector<Point> compared = points(picture, view);
        for (const Point& point : compared) normals.push_back(point.normal);
        const auto averages = sampled(gpu, mips_of(gpu, environment.cube),
                                      {.exponent = 1.0f, .samples = samples}, normals);
        // Levels differ by a rounding of log2, and normals by one: of light that varies by 2 over
        // a radian.
        for (std::size_t i = 0; i < compared.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(picture.texels[compared[i].pixel + c], averages[i][c], 2e-5f);
    }
}

TEST_F(SphereImportanceTest, ConvergesToTheTruth) {
    // Light from 0 to 2 makes one sample's share of ks at most 2 (n + 2) / (n + 1), so its standard
    // deviation is at most half of that; the fetches' filter adds nothing at 1024 samples.
    const auto source = oracle::random_cube(oracle::Scene::smooth, 64, 12);
    const host::GpuEnvironment environment = upload(image_of(source));
    for (const double n : {0.0, 4.8, 64.0}) {
        const SphereView view{.camera = {.eye = {-2, 1, 3}},
                              .material = grey(0.0f, 1.0f, float(n)),
                              .width = 14,
                              .height = 14};
        for (const std::uint32_t samples : {16u, 1024u}) {
            const host::Image picture = draw_samples(environment, view, samples);
            const std::vector<Point> compared = points(picture, view);
            double squares = 0;
            for (const Point& point : compared) {
                const Rgb truth = specular_average(source, point.normal, point.mirror, n);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double error = double(picture.texels[point.pixel + c]) - truth[c];
                    squares += error * error;
                }
            }
            EXPECT_LE(std::sqrt(squares / double(3 * compared.size())),
                      (n + 2) / (n + 1) / std::sqrt(double(samples)))
                << "n " << n << " N " << samples;
        }
    }
}

} // namespace
} // namespace lobelia::test
