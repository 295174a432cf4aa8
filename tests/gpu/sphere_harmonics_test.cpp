#include <cstring>

#include <lobelia/irradiance.h>

#include "sphere_fixture.h"
#include "support/harmonics.h"

// The diffuse lobe by spherical harmonics, against closed forms and sums in double precision.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;

constexpr int MOST_DEGREE = 4;
constexpr std::size_t MOST_HARMONICS = (MOST_DEGREE + 1) * (MOST_DEGREE + 1);

/// A texel is even light over its area; the sums take it in parts, of which a face has at least 128
/// a side.
int parts_of(int size) {
    int parts = 1;
    while (size * parts < 128) parts *= 2;
    return parts;
}

/// The series of the light's average over the lobe of exponent 1: parts of texels at their middles,
/// by their solid angle.
class Series {
public:
    explicit Series(const oracle::Source& source) {
        const int parts = parts_of(source.width()), size = parts * source.width();
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    add(oracle::cube_direction(face, x + 0.5, y + 0.5, size),
                        oracle::cube_texel_solid_angle(x, y, size),
                        source.texel(face, x / parts, y / parts));
    }

    /// Up to a degree; what would be below 0 is 0.
    Rgb about(Direction normal, int degree) const {
        Rgb value = added(sum_, normal, degree, false);
        for (double& channel : value) channel = std::max(channel, 0.0);
        return value;
    }
    /// The same of absolute values: what roundings are relative to.
    Rgb magnitude(Direction normal, int degree) const { return added(size_, normal, degree, true); }

private:
    using Sums = std::array<Rgb, MOST_HARMONICS>;

    void add(Direction direction, double solid_angle, const Rgb& light) {
        for (std::size_t i = 0; i < MOST_HARMONICS; ++i) {
            const double value = solid_angle * harmonic(i, direction);
            for (std::size_t c = 0; c < 3; ++c) {
                sum_[i][c] += value * light[c];
                size_[i][c] += std::abs(value) * light[c];
            }
        }
    }
    static int degree_of(std::size_t i) { return int(std::sqrt(double(i))); }
    static double harmonic(std::size_t i, Direction d) {
        const int l = degree_of(i);
        return oracle::harmonic(l, int(i) - l * l - l, d);
    }
    static Rgb added(const Sums& sums, Direction normal, int degree, bool absolute) {
        Rgb value{};
        for (std::size_t i = 0; i < MOST_HARMONICS && degree_of(i) <= degree; ++i) {
            const double factor = oracle::lobe_eigenvalue(1.0, degree_of(i)) * harmonic(i, normal);
            for (std::size_t c = 0; c < 3; ++c)
                value[c] += (absolute ? std::abs(factor) : factor) * sums[i][c];
        }
        return value;
    }

    Sums sum_{};
    Sums size_{};
};

class SphereHarmonicsTest : public SphereTest {
protected:
    /// Compares the picture of a white matte sphere, `expected(normal, degree)` being what each
    /// normal shows and `slack` how far off it may be.
    template <class Expected, class Slack>
    void expect_light(const host::Image& image, Expected expected, Slack slack) {
        const host::GpuEnvironment environment = upload(image);
        oracle::Random random(5);
        for (const auto& [method, degree] :
             {std::pair{SphereMethod::sh2, 2}, {SphereMethod::sh4, 4}}) {
            const SphereView view{.camera = {.eye = floats(4.0 * random.direction())},
                                  .material = grey(1.0f, 0.0f, 1.0f),
                                  .width = 16,
                                  .height = 16};
            const host::Image picture = draw(environment, view, method);
            const oracle::Camera camera = oracle_camera(view);
            int compared = 0;
            for (std::uint32_t i = 0; i < 256; ++i) {
                const float* const pixel = &picture.texels[std::size_t(4) * i];
                const auto hit =
                    oracle::meet_sphere(camera.eye, ray(camera, i % 16 + 0.5, i / 16 + 0.5));
                if (!hit || pixel[3] < 1.0f) continue;
                const Rgb truth = expected(hit->normal, degree), bound = slack(hit->normal, degree);
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_NEAR(double(pixel[c]), truth[c], bound[c])
                        << "degree " << degree << " pixel " << i;
                ++compared;
            }
            EXPECT_GT(compared, 120);
        }
    }

    std::vector<float> coefficients(const host::GpuImage& cube) {
        const auto buffer = [&](VkDeviceSize size) {
            return value_of(
                gpu.create_buffer(size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::host));
        };
        const host::GpuBuffer scratch = buffer(Irradiance::scratch_size(cube_of(cube)));
        const host::GpuBuffer result = buffer(Irradiance::COEFFICIENTS_SIZE);
        std::memset(scratch.data(), 0xff, scratch.size()); // NaN: nothing leans on what was there
        const Irradiance irradiance = value_of(Irradiance::create(gpu.device()));
        const IrradianceJob job =
            value_of(irradiance.bind(cube_of(cube), scratch.handle(), result.handle()));
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
        std::vector<float> values(result.size() / sizeof(float));
        std::memcpy(values.data(), result.data(), result.size());
        return values;
    }
};

TEST_F(SphereHarmonicsTest, GiveTheIrradianceOfLinearAndQuadraticLight) {
    // Funk-Hecke: what is linear in the direction keeps 2/3 of itself, a harmonic of degree 2 a
    // quarter. The sums take texels at their middles: an error of h^2 / 24 times the second
    // derivatives, texels being h = 2/128 wide and those of 2 + d.a + (d.b)^2 times a degree's
    // polynomial at most 20.
    const Direction a = oracle::test_directions(8, 3)[6], b = oracle::test_directions(8, 3)[7];
    const oracle::Source source = oracle::cube_of(128, [&](Direction d) {
        const double value = 2 + dot(d, a) + dot(d, b) * dot(d, b);
        return Rgb{value, 2 * value, 3 * value};
    });
    const double bound = 20.0 / (64 * 64 * 24);
    expect_light(
        image_of(source),
        [&](Direction n, int) {
            const double square = dot(n, b) * dot(n, b) - 1.0 / 3;
            const double value = 2 + 1.0 / 3 + 2.0 / 3 * dot(n, a) + 0.25 * square;
            return Rgb{value, 2 * value, 3 * value};
        },
        [&](Direction, int) {
            return Rgb{bound, 2 * bound, 3 * bound};
        });
}

TEST_F(SphereHarmonicsTest, AreTheSumsOfTheTexelsToTheirDegree) {
    for (const auto& [scene, size] : {std::pair{oracle::Scene::noise, 64},
                                      {oracle::Scene::suns, 16},
                                      {oracle::Scene::halves, 5},
                                      {oracle::Scene::noise, 1}}) {
        SCOPED_TRACE(std::string(oracle::name(scene)) + " " + std::to_string(size));
        const oracle::Source source = oracle::random_cube(scene, size, 21);
        const Series series(source);
        // A rounding for each term of a row, of a face's rows and of the faces, and some for the
        // functions and the normal.
        const double roundings = (2 * parts_of(size) * size + 6 + 40) * 0x1p-24;
        expect_light(
            image_of(source), [&](Direction n, int degree) { return series.about(n, degree); },
            [&](Direction n, int degree) {
                Rgb slack = series.magnitude(n, degree);
                for (double& channel : slack) channel *= roundings;
                return slack;
            });
    }
}

TEST_F(SphereHarmonicsTest, ShowTheSpecularLobeAsSplitSumDoes) {
    const host::GpuEnvironment environment =
        upload(image_of(oracle::random_cube(oracle::Scene::suns, 16, 8)));
    const SphereView view{.material = grey(0.0f, 0.5f, 20.0f), .width = 12, .height = 10};
    const host::Image expected = draw(environment, view, SphereMethod::split_sum);
    for (const SphereMethod method : {SphereMethod::sh2, SphereMethod::sh4}) {
        const host::Image picture = draw(environment, view, method);
        for (std::size_t i = 0; i < picture.texels.size(); ++i)
            ASSERT_NEAR(picture.texels[i], expected.texels[i], 1e-6f * expected.texels[i]) << i;
    }
}

TEST_F(SphereHarmonicsTest, HaveTheSameBitsEveryTime) {
    const host::GpuImage cube =
        on_device(gpu, image_of(oracle::random_cube(oracle::Scene::suns, 100, 2)));
    const std::vector<float> first = coefficients(cube);
    for (int i = 0; i < 4; ++i) {
        const std::vector<float> again = coefficients(cube);
        ASSERT_EQ(std::memcmp(again.data(), first.data(), first.size() * sizeof(float)), 0);
    }
}

TEST_F(SphereHarmonicsTest, TakeWhatIsNoRadianceForNoneOrMuch) {
    host::Image image = image_of(oracle::random_cube(oracle::Scene::noise, 4, 6));
    image.texel(2, 1, 3)[1] = std::numeric_limits<float>::quiet_NaN();
    image.texel(3, 1, 3)[0] = -1e30f;
    image.texel(1, 0, 2)[2] = std::numeric_limits<float>::infinity();
    for (const float value : coefficients(on_device(gpu, image)))
        ASSERT_TRUE(std::isfinite(value)) << value;
    EXPECT_FALSE(value_of(Irradiance::create(gpu.device())).bind({.size = 0}, {}, {}));
}

} // namespace
} // namespace lobelia::test
