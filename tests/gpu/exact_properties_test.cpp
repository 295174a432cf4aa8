#include "exact_fixture.h"

#include <limits>

#include "support/harmonics.h"
#include "support/some_of.h"

// What holds for every environment, without another integration to compare with.
namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Rgb;
using oracle::Scene;
using oracle::Source;

// Sums of 32-bit numbers in a row, of which none is longer than this, lose so much of themselves.
constexpr double SUMMATION = 300 * 0x1p-24;

double relative(float found, double truth) {
    return std::abs(double(found) / truth - 1);
}

class ExactPropertiesTest : public ExactTest {
protected:
    void expect_even_light(const Source& source, const std::vector<float>& exponents) {
        const host::GpuImage image = on_device(gpu, image_of(source));
        Directions axes = oracle::test_directions(7, 1);
        axes.push_back(oracle::normalised({1, 1, 1}));
        for (float n : exponents)
            for (const Average& found : averages(image, n, axes)) {
                EXPECT_LE(relative(found[0], double(0.3f)), SUMMATION);
                EXPECT_LE(relative(found[1], 1), SUMMATION);
                EXPECT_LE(relative(found[3], 2 * oracle::PI / (double(n) + 1)), 1e-5)
                    << shape_of(source) << " n " << n;
                worst = std::max(worst, relative(found[3], 2 * oracle::PI / (double(n) + 1)));
            }
    }
    double worst = 0;
};

TEST_F(ExactPropertiesTest, LeaveEvenLightOnPanoramasAsItIs) {
    const auto light = [](Direction) { return Rgb{0.3, 1, 7}; };
    expect_even_light(oracle::panorama_of(1, 1, light), {0, 1e-30f, 0.5f, 1, 3.9f, 4, 16, 1e4f});
    expect_even_light(oracle::panorama_of(17, 9, light), {0, 2, 16, 300, 1e5f});
    expect_even_light(oracle::panorama_of(64, 1, light), {0, 3.9f, 1e4f, 1e6f});
    expect_even_light(oracle::panorama_of(1, 64, light), {0, 3.9f, 1e4f});
    // 24 and 25: where the rule changes for 300 columns.
    expect_even_light(oracle::panorama_of(300, 100, light), {0, 4, 24, 25, 300});
    expect_even_light(oracle::panorama_of(1023, 511, light), {1, 64});
    RecordProperty("worst", std::to_string(worst));
}

TEST_F(ExactPropertiesTest, LeaveEvenLightOnCubesAsItIs) {
    const auto light = [](Direction) { return Rgb{0.3, 1, 7}; };
    expect_even_light(oracle::cube_of(1, light), {0, 1e-30f, 0.5f, 1, 3.9f, 4, 16, 1e4f});
    expect_even_light(oracle::cube_of(2, light), {0, 64, 1e3f});
    expect_even_light(oracle::cube_of(3, light), {3.9f, 300, 1e5f});
    for (int size : {8, 17}) expect_even_light(oracle::cube_of(size, light), {1, 30, 1e4f});
    // 24 and 25, 6.5 and 6.6: where the rule changes for 64 and 512 texels a side
    expect_even_light(oracle::cube_of(64, light), {4, 24, 25, 300, 1e6f});
    expect_even_light(oracle::cube_of(255, light), {0, 64, 1e4f});
    expect_even_light(oracle::cube_of(512, light), {6.5f, 6.6f, 1e6f});
    RecordProperty("worst", std::to_string(worst));
}

TEST_F(ExactPropertiesTest, ScaleEachDegreeByItsEigenvalue) {
    // Funk-Hecke. The light is 1 + Y / 2, one order of one degree a channel.
    constexpr int SIZE = 256;
    constexpr int DEGREES[2][3] = {{1, 2, 3}, {4, 4, 2}};
    constexpr int ORDERS[2][3] = {{0, 1, -2}, {3, 0, -1}};
    const Directions axes = oracle::test_directions(12, 2);
    for (std::size_t set = 0; set < 2; ++set) {
        const auto harmonic = [&](std::size_t c, Direction d) {
            return oracle::harmonic(DEGREES[set][c], ORDERS[set][c], d);
        };
        const host::GpuImage image =
            on_device(gpu, image_of(oracle::cube_of(SIZE, [&](Direction d) {
                          return Rgb{1 + 0.5 * harmonic(0, d), 1 + 0.5 * harmonic(1, d),
                                     1 + 0.5 * harmonic(2, d)};
                      })));
        for (float n : {0.0f, 1.0f, 2.0f, 4.8f, 64.0f}) {
            const std::vector<Average> found = averages(image, n, axes);
            for (std::size_t i = 0; i < axes.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c) {
                    const int l = DEGREES[set][c];
                    // Texels hold the light of their middles: off by h^2 / 24 times the
                    // Laplacian, -l (l + 1) Y, and twice that through the weight's slope.
                    const double h = 2.0 / SIZE;
                    const double sampling = 0.5 * 3 * h * h / 24 * l * (l + 1);
                    const double truth =
                        1 + 0.5 * oracle::lobe_eigenvalue(double(n), l) * harmonic(c, axes[i]);
                    EXPECT_NEAR(double(found[i][c]), truth, sampling + SUMMATION)
                        << "degree " << l << " n " << n;
                    worst = std::max(worst, std::abs(double(found[i][c]) - truth));
                }
        }
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST_F(ExactPropertiesTest, AreLinearInTheLight) {
    const Source first = oracle::random_panorama(Scene::suns, 17, 9, 3);
    const Source second = oracle::random_panorama(Scene::noise, 17, 9, 4);
    Source both = first;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 17; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                both.texel(0, x, y)[c] = 3 * first.texel(0, x, y)[c] + second.texel(0, x, y)[c];
    const Directions axes = oracle::test_directions(12, 5);
    for (float n : {0.0f, 1.0f, 4.8f, 300.0f}) {
        const std::vector<Average> a = averages(first, n, axes);
        const std::vector<Average> b = averages(second, n, axes);
        const std::vector<Average> sum = averages(both, n, axes);
        for (std::size_t i = 0; i < axes.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_LE(relative(sum[i][c], 3 * double(a[i][c]) + double(b[i][c])),
                          2 * SUMMATION);
    }
}

TEST_F(ExactPropertiesTest, StayBetweenTheLeastAndTheMostLight) {
    for (const Source& source : {oracle::random_panorama(Scene::noise, 5, 3, 6),
                                 oracle::random_cube(Scene::noise, 3, 7)}) {
        double least = std::numeric_limits<double>::max();
        for (const Rgb& texel : source.texels()) least = std::min(least, texel[0]);
        const double most = largest(source)[0];
        for (float n : {0.0f, 0.5f, 1.0f, 16.0f, 1e4f})
            for (const Average& found : averages(source, n, oracle::test_directions(16, 8))) {
                EXPECT_GE(double(found[0]), least * (1 - SUMMATION)) << "n " << n;
                EXPECT_LE(double(found[0]), most * (1 + SUMMATION)) << "n " << n;
            }
    }
}

// The 24 turns of a cube: where they take +X, +Y and +Z.
std::vector<std::array<Direction, 3>> turns() {
    const Direction ways[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<Direction, 3>> all;
    for (Direction x : ways)
        for (Direction y : ways)
            if (oracle::dot(x, y) == 0) all.push_back({x, y, oracle::cross(x, y)});
    return all;
}

TEST_F(ExactPropertiesTest, TurnWithTheCube) {
    const int size = 5;
    const Source source = oracle::random_cube(Scene::suns, size, 9);
    const Directions axes = oracle::test_directions(16, 10);
    const auto turned_by = [](const std::array<Direction, 3>& turn, Direction d) {
        return d.x * turn[0] + d.y * turn[1] + d.z * turn[2];
    };
    for (float n : {4.8f, 64.0f}) {
        const std::vector<Average> before = averages(source, n, axes);
        for (const auto& turn : some_of(turns())) {
            Source turned = source;
            Directions turned_axes;
            for (Direction axis : axes) turned_axes.push_back(turned_by(turn, axis));
            for (int face = 0; face < 6; ++face)
                for (int y = 0; y < size; ++y)
                    for (int x = 0; x < size; ++x) {
                        const oracle::FacePoint to =
                            oracle::cube_point(turned_by(turn, source.direction(face, x, y)), size);
                        turned.texel(to.face, int(to.x), int(to.y)) = source.texel(face, x, y);
                    }
            const std::vector<Average> after = averages(turned, n, turned_axes);
            for (std::size_t i = 0; i < axes.size(); ++i) {
                const double error = std::abs(double(after[i][0]) - double(before[i][0])) /
                                     std::max(double(before[i][0]), 1e-6 * largest(source)[0]);
                EXPECT_LE(error, 1e-4) << "n " << n;
                worst = std::max(worst, error);
            }
        }
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST_F(ExactPropertiesTest, SeeALoneTexelByItsSolidAngleOnly) {
    // n = 0: all of it in front, none of it behind.
    Source source = oracle::panorama_of(64, 32, [](Direction) { return Rgb{}; });
    source.texel(0, 20, 9) = {1e9, 0, 0};
    source.texel(0, 0, 31)[1] = 0x1p100; // at a pole, in one channel
    const Direction sun = source.direction(0, 20, 9);
    const double share = source.solid_angle(20, 9) / (2 * oracle::PI);
    const std::vector<Average> found =
        averages(source, 0, {sun, -1.0 * sun, {0, -1, 0}, {0, 1, 0}});
    EXPECT_LE(relative(found[0][0], 1e9 * share), 1e-5);
    EXPECT_EQ(found[1][0], 0.0f);
    EXPECT_LE(relative(found[2][1], 0x1p100 * source.solid_angle(0, 31) / (2 * oracle::PI)), 1e-5);
    for (float n : {64.0f, 1e3f}) {
        const std::vector<Average> sharp = averages(source, n, {{0, 1, 0}, {0, 0, 1}});
        EXPECT_EQ(sharp[0][1], 0.0f) << "n " << n; // the other pole
        EXPECT_LT(sharp[1][1], 0x1p100f * 1e-9f) << "n " << n;
    }
}

TEST_F(ExactPropertiesTest, GiveHalfAtTheEdgeOfAHalfSphere) {
    const auto front = [](Direction d) { return grey(d.z > 0 ? 1 : 0); };
    for (const Source& source :
         {oracle::panorama_of(4, 3, front), oracle::panorama_of(64, 32, front),
          oracle::cube_of(2, front), oracle::cube_of(16, front)})
        for (float n : {0.0f, 0.5f, 1.0f, 3.0f, 4.8f, 64.0f, 1e3f, 1e4f}) {
            const std::vector<Average> found =
                averages(source, n, {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0.6, -0.8, 0}});
            SCOPED_TRACE(shape_of(source) + " n " + std::to_string(n));
            EXPECT_NEAR(double(found[0][0]), 1, 1e-6);
            EXPECT_NEAR(double(found[1][0]), 0, 1e-6);
            for (std::size_t i = 2; i < 5; ++i) EXPECT_NEAR(double(found[i][0]), 0.5, SUMMATION);
        }
}

} // namespace
} // namespace lobelia::test
