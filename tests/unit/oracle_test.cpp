#include "support/oracle.h"

#include <gtest/gtest.h>

#include "support/environments.h"
#include "support/harmonics.h"

// The oracle against closed forms: what every other test leans on.
namespace lobelia::oracle {
namespace {

constexpr double EXPONENTS[] = {0, 1e-30, 1e-6, 0.5, 1, 1.5, 2, 4.8, 16, 64, 1000.5, 1e4, 1e6};

std::vector<Source> sources_of(const Rgb& light) {
    std::vector<Source> sources;
    for (auto [width, height] : {std::pair{1, 1}, {2, 1}, {3, 2}, {17, 9}, {64, 32}})
        sources.push_back(panorama_of(width, height, [=](Direction) { return light; }));
    for (int size : {1, 2, 5, 16})
        sources.push_back(cube_of(size, [=](Direction) { return light; }));
    return sources;
}

std::string size_of(const Source& source) {
    return (source.is_cube() ? "cube " : "panorama ") + std::to_string(source.width()) + " x " +
           std::to_string(source.height());
}

Rgb grey(double value) {
    return {value, value, value};
}

// A panorama whose rows are even, with one row 1e6 times as bright.
Source bands(int height, std::uint64_t seed) {
    Random random(seed);
    Source source = Source::panorama(5, height, std::vector<Rgb>(std::size_t(5 * height)));
    for (int y = 0; y < height; ++y) {
        const Rgb light = grey(random.between(0.5, 2) * (y == height / 3 ? 1e6 : 1));
        for (int x = 0; x < 5; ++x) source.texel(0, x, y) = light;
    }
    return source;
}

double sine_of_edge(int y, int height) {
    return std::sin(PI * (0.5 - double(y) / height));
}

TEST(Oracle, LeavesConstantLightAsItIs) {
    for (const Source& source : sources_of({1, 2, 0.5}))
        for (double n : EXPONENTS)
            for (Direction axis : test_directions(n < 20 ? 7 : 4, 1)) {
                SCOPED_TRACE(size_of(source) + " n " + std::to_string(n));
                const Rgb analytic = lobe_average(source, axis, n);
                EXPECT_NEAR(analytic[0], 1, 5e-9);
                EXPECT_NEAR(analytic[1], 2, 1e-8);
                const Rgb weighed = lobe_average(source, axis, n, {Normalise::by_weight});
                EXPECT_NEAR(weighed[2], 0.5, 1e-14);
            }
}

TEST(Oracle, ShadesInConstantLightByTheAlbedo) {
    Random random(2);
    for (const Source& source : sources_of(grey(1)))
        for (double n : EXPONENTS)
            for (int i = 0; i < 3; ++i) {
                const Direction normal = random.direction();
                const Direction view = random.direction_above(normal);
                const Material material{grey(0.3), {0.6, 0.2, 0}, n};
                const Rgb radiance = shade(source, normal, view, material);
                const double w = albedo(dot(normal, view), n);
                SCOPED_TRACE(size_of(source) + " n " + std::to_string(n));
                EXPECT_NEAR(radiance[0], 0.3 + 0.6 * w, 5e-9);
                EXPECT_NEAR(radiance[1], 0.3 + 0.2 * w, 5e-9);
            }
}

TEST(Oracle, GivesHalfAtTheEdgeOfAHalfSphere) {
    const auto front = [](Direction d) { return grey(d.z > 0 ? 1 : 0); };
    for (const Source& source : {panorama_of(4, 3, front), panorama_of(64, 32, front),
                                 cube_of(2, front), cube_of(16, front)})
        for (double n : EXPONENTS) {
            SCOPED_TRACE(size_of(source) + " n " + std::to_string(n));
            EXPECT_NEAR(lobe_average(source, {0, 0, 1}, n)[0], 1, 5e-9);
            EXPECT_NEAR(lobe_average(source, {0, 0, -1}, n)[0], 0, 1e-14);
            for (Direction equator : {Direction{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}})
                EXPECT_NEAR(lobe_average(source, equator, n)[0], 0.5, 5e-9);
        }
}

TEST(Oracle, KnowsTheOverlapOfTwoHalfSpheres) {
    const auto front = [](Direction d) { return grey(d.z > 0 ? 1 : 0); };
    for (const Source& source : {panorama_of(4, 1, front), panorama_of(64, 32, front),
                                 cube_of(2, front), cube_of(16, front)})
        for (Direction axis : test_directions(20, 3)) {
            SCOPED_TRACE(size_of(source));
            const double lune = 1 - angle(axis, {0, 0, 1}) / PI;
            EXPECT_NEAR(lobe_average(source, axis, 0)[0], lune, 5e-9);
            EXPECT_NEAR(lobe_average(source, axis, 1)[0], 0.5 * (1 + axis.z), 5e-9);
        }
}

TEST(Oracle, IntegratesBandsAroundThePoleInClosedForm) {
    const int height = 9; // odd: the horizon cuts the middle row
    const Source source = bands(height, 4);
    for (double n : {0.0, 0.3, 1.0, 4.8, 64.0, 1e4, 1e6})
        for (int sign : {1, -1}) {
            double exact = 0;
            for (int y = 0; y < height; ++y) {
                const double a = std::max(0.0, sign * sine_of_edge(y, height));
                const double b = std::max(0.0, sign * sine_of_edge(y + 1, height));
                exact +=
                    source.texel(0, 0, y)[0] * std::abs(std::pow(a, n + 1) - std::pow(b, n + 1));
            }
            EXPECT_NEAR(lobe_average(source, {0, double(sign), 0}, n)[0] / exact, 1, 2e-9)
                << "n " << n << " pole " << sign;
        }
}

TEST(Oracle, ScalesEachDegreeByItsEigenvalue) {
    // Bands again, seen from anywhere: a Legendre series, each degree scaled (Funk-Hecke).
    const int height = 12;
    const Source source = bands(height, 5);
    const double mean = source.mean()[0];
    for (double n : {9.5, 16.0, 64.0, 300.0})
        for (Direction axis : test_directions(12, 6)) {
            double exact = mean;
            for (int l = 1; l <= 250; ++l) {
                double coefficient = 0; // (2l + 1) / 2 times the integral of light P_l
                for (int y = 0; y < height; ++y) {
                    const auto primitive = [&](double s) {
                        return legendre(l + 1, s) - legendre(l - 1, s);
                    };
                    coefficient += 0.5 * source.texel(0, 0, y)[0] *
                                   (primitive(sine_of_edge(y, height)) -
                                    primitive(sine_of_edge(y + 1, height)));
                }
                exact += lobe_eigenvalue(n, l) * coefficient * legendre(l, axis.y);
            }
            EXPECT_NEAR(lobe_average(source, axis, n)[0], exact, 1e-9 * mean)
                << "n " << n << " axis y " << axis.y;
        }
}

TEST(Oracle, SeesTheTexelThatAVerySharpLobePointsAt) {
    for (const Source& source :
         {random_panorama(Scene::noise, 32, 16, 7), random_cube(Scene::noise, 8, 8)}) {
        Random random(9);
        for (int i = 0; i < 40; ++i) {
            const int layer = random.below(source.layers());
            const int x = random.below(source.width());
            const int y = random.below(source.height());
            const Rgb seen = lobe_average(source, source.direction(layer, x, y), 1e6);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(seen[c] / source.texel(layer, x, y)[c], 1, 2e-9);
        }
    }
}

TEST(Oracle, KeepsASunOutOfTheHalfSphereBehindIt) {
    Source source = panorama_of(16, 8, [](Direction) { return grey(0.125); });
    source.texel(0, 3, 0) = grey(1e9);
    for (double n : {0.0, 0.5, 1.0, 64.0})
        EXPECT_NEAR(lobe_average(source, {0, -1, 0}, n)[0], 0.125, 1e-9) << "n " << n;
}

TEST(Oracle, IsLinearInTheLight) {
    const Source first = random_panorama(Scene::suns, 17, 9, 10);
    const Source second = random_panorama(Scene::noise, 17, 9, 11);
    Source both = first;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 17; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                both.texel(0, x, y)[c] += 2 * second.texel(0, x, y)[c];
    for (double n : {0.0, 1.0, 4.8, 300.0})
        for (Direction axis : test_directions(8, 12)) {
            const double sum =
                lobe_average(first, axis, n)[1] + 2 * lobe_average(second, axis, n)[1];
            EXPECT_NEAR(lobe_average(both, axis, n)[1] / sum, 1, 1e-13);
        }
}

TEST(Oracle, TurnsWithThePanorama) {
    const Source source = random_panorama(Scene::suns, 16, 9, 13);
    Source turned = source; // a quarter about +Y: +Z goes to +X, a quarter to the left
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 16; ++x) turned.texel(0, x, y) = source.texel(0, (x + 4) % 16, y);
    for (double n : {0.0, 0.5, 1.0, 64.0})
        for (Direction axis : test_directions(20, 14)) {
            const double before = lobe_average(source, axis, n)[0];
            const double after = lobe_average(turned, {axis.z, axis.y, -axis.x}, n)[0];
            EXPECT_NEAR(after / before, 1, 1e-8) << "n " << n;
        }
}

TEST(Oracle, ShadesHeadOnByTheNextExponent) {
    // N = R: max(0, w . R)^n (N . w) is the lobe of n + 1.
    const Source source = random_panorama(Scene::suns, 17, 9, 15);
    for (double n : {0.0, 0.5, 1.0, 4.8, 64.0, 1e4})
        for (Direction normal : test_directions(8, 16)) {
            const Rgb radiance = shade(source, normal, normal, {{}, grey(1), n});
            EXPECT_NEAR(radiance[0] / lobe_average(source, normal, n + 1)[0], 1, 2e-8) << "n " << n;
        }
}

TEST(Oracle, AveragesOnTwoThreadsAsOnOne) {
    const Source source = random_panorama(Scene::noise, 32, 16, 17);
    const std::vector<Direction> axes = test_directions(30, 18);
    const std::vector<Rgb> averages = lobe_averages(source, axes, 4.8);
    for (std::size_t i = 0; i < axes.size(); ++i)
        EXPECT_EQ(averages[i], lobe_average(source, axes[i], 4.8));
}

TEST(Albedo, HasItsClosedForms) {
    for (double n : EXPONENTS) {
        EXPECT_NEAR(albedo(1, n), 1, 1e-12) << "n " << n;
        EXPECT_NEAR(albedo(-1, n), 0, 1e-12) << "n " << n;
        // At the horizon: (n + 2) / (2 pi) B((n + 1) / 2, 3 / 2).
        const double edge =
            (n + 2) / (2 * PI) *
            std::exp(std::lgamma((n + 1) / 2) + std::lgamma(1.5) - std::lgamma(n / 2 + 2));
        EXPECT_NEAR(albedo(0, n) / edge, 1, n < 1e4 ? 1e-11 : 1e-8) << "n " << n;
    }
    EXPECT_NEAR(albedo(0, 1), 1 / PI, 1e-13);
    for (double c : {-0.9, -0.1, 0.0, 0.01, 0.5, 0.99})
        EXPECT_NEAR(albedo(c, 0), 0.5 * (1 + c), 1e-12) << "N.R " << c;
}

} // namespace
} // namespace lobelia::oracle
