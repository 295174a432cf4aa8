#include <gtest/gtest.h>

#include "support/camera.h"
#include "support/environments.h"
#include "support/error_measures.h"
#include "support/harmonics.h"
#include "support/quadrature.h"

// The conventions and the tools that the oracle and the other tests are made of.
namespace lobelia::oracle {
namespace {

void expect_direction(Direction actual, Direction expected) {
    const Direction unit = normalised(expected);
    EXPECT_NEAR(actual.x, unit.x, 1e-12);
    EXPECT_NEAR(actual.y, unit.y, 1e-12);
    EXPECT_NEAR(actual.z, unit.z, 1e-12);
}

TEST(PanoramaConvention, PutsFrontInTheMiddleAndPlusXOnTheLeft) {
    expect_direction(panorama_direction(50, 25, 100, 50), {0, 0, 1});
    expect_direction(panorama_direction(25, 25, 100, 50), {1, 0, 0});
    expect_direction(panorama_direction(75, 25, 100, 50), {-1, 0, 0});
    expect_direction(panorama_direction(0, 25, 100, 50), {0, 0, -1});
    expect_direction(panorama_direction(100, 25, 100, 50), {0, 0, -1});
    expect_direction(panorama_direction(3, 0, 100, 50), {0, 1, 0});
    const Angles angles = panorama_angles(panorama_direction(20, 10, 100, 50));
    EXPECT_NEAR(angles.longitude, 2 * PI * 0.3, 1e-14);
    EXPECT_NEAR(angles.latitude, PI * 0.3, 1e-14);
}

TEST(CubeConvention, HasTheCornersOfVulkansTable) {
    // Top left and top right corner of each face, from s = (s_c / |r| + 1) / 2, t likewise.
    const Direction top_left[] = {{1, 1, 1},   {-1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1}, {-1, 1, 1},  {1, 1, -1}};
    const Direction top_right[] = {{1, 1, -1}, {-1, 1, 1}, {1, 1, -1},
                                   {1, -1, 1}, {1, 1, 1},  {-1, 1, -1}};
    for (int face = 0; face < 6; ++face) {
        SCOPED_TRACE(face);
        expect_direction(cube_direction(face, 0, 0, 4), top_left[face]);
        expect_direction(cube_direction(face, 4, 0, 4), top_right[face]);
        const FacePoint point = cube_point(cube_direction(face, 1.25, 3, 4), 4);
        EXPECT_EQ(point.face, face);
        EXPECT_NEAR(point.x, 1.25, 1e-14);
        EXPECT_NEAR(point.y, 3, 1e-14);
    }
}

TEST(SolidAngle, AddsUpToTheSphere) {
    for (auto [width, height] : {std::pair{1, 1}, {17, 9}, {1024, 512}}) {
        double sum = 0;
        for (int y = 0; y < height; ++y)
            sum += width * panorama_texel_solid_angle(y, width, height);
        EXPECT_NEAR(sum, 4 * PI, 1e-12);
    }
    for (int size : {1, 3, 64}) {
        double sum = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) sum += 6 * cube_texel_solid_angle(x, y, size);
        EXPECT_NEAR(sum, 4 * PI, 1e-12);
    }
    // A small texel is its area over the cube of its distance.
    EXPECT_NEAR(cube_texel_solid_angle(0, 0, 1024) / (4.0 / 1024 / 1024 / std::pow(3, 1.5)), 1,
                3e-3);
}

TEST(Quadrature, IntegratesPolynomialsAndRoots) {
    for (int points : {1, 2, 7, 20, 64}) {
        const GaussRule& rule = gauss(points);
        for (int power : {0, 2 * points - 2}) {
            double sum = 0;
            for (std::size_t i = 0; i < rule.at.size(); ++i)
                sum += rule.weight[i] * std::pow(rule.at[i], power);
            EXPECT_NEAR(sum * (power + 1), 2, 1e-12) << points << " points, power " << power;
        }
    }
    const auto root = [](double x, double rest) { return std::sqrt(x) * std::sqrt(rest); };
    EXPECT_NEAR(tanh_sinh(root), PI / 8, 1e-14);
}

TEST(Harmonics, AreOrthonormal) {
    // 32 latitudes by 40 longitudes integrate products of degree 16 exactly.
    const GaussRule& rule = gauss(32);
    std::vector<double> products(81 * 81);
    for (std::size_t i = 0; i < rule.at.size(); ++i)
        for (int j = 0; j < 40; ++j) {
            const double longitude = 2 * PI * j / 40;
            const double across = std::sqrt(1 - rule.at[i] * rule.at[i]);
            const Direction d{across * std::sin(longitude), rule.at[i],
                              across * std::cos(longitude)};
            std::vector<double> values;
            for (int l = 0; l <= 8; ++l)
                for (int m = -l; m <= l; ++m) values.push_back(harmonic(l, m, d));
            for (std::size_t a = 0; a < 81; ++a)
                for (std::size_t b = 0; b < 81; ++b)
                    products[a * 81 + b] += rule.weight[i] * 2 * PI / 40 * values[a] * values[b];
        }
    for (std::size_t a = 0; a < 81; ++a)
        for (std::size_t b = 0; b < 81; ++b)
            EXPECT_NEAR(products[a * 81 + b], a == b ? 1 : 0, 1e-12) << a << " and " << b;
    EXPECT_NEAR(harmonic(1, 1, {0, 0, 1}), std::sqrt(3 / (4 * PI)), 1e-15);
    EXPECT_NEAR(harmonic(1, -1, {1, 0, 0}), std::sqrt(3 / (4 * PI)), 1e-15);
    EXPECT_NEAR(harmonic(1, 0, {0, 1, 0}), std::sqrt(3 / (4 * PI)), 1e-15);
}

TEST(Harmonics, HaveTheLobesEigenvalues) {
    EXPECT_DOUBLE_EQ(lobe_eigenvalue(1, 1), 2.0 / 3);
    EXPECT_DOUBLE_EQ(lobe_eigenvalue(1, 2), 0.25);
    EXPECT_DOUBLE_EQ(lobe_eigenvalue(1, 3), 0);
    EXPECT_DOUBLE_EQ(lobe_eigenvalue(1, 4), -1.0 / 24);
    for (double n : {0.0, 0.5, 4.8, 64.0})
        for (int l = 0; l <= 8; ++l) {
            const double integral = tanh_sinh(
                [&](double x, double) { return (n + 1) * std::pow(x, n) * legendre(l, x); });
            EXPECT_NEAR(lobe_eigenvalue(n, l), integral, 1e-12) << "n " << n << " l " << l;
        }
}

TEST(Camera, LooksAtTheSphere) {
    const Camera camera;
    expect_direction(ray(camera, 256, 256), {0, 0, -1});
    const double half = std::tan(15 * PI / 180);
    expect_direction(ray(camera, 512, 0), {half, half, -1});
    Camera wide = camera;
    wide.width = 1024;
    expect_direction(ray(wide, 1024, 512), {2 * half, -half, -1});

    const auto front = meet_sphere(camera.eye, {0, 0, -1});
    ASSERT_TRUE(front);
    expect_direction(front->normal, {0, 0, 1});
    expect_direction(front->view, {0, 0, 1});
    EXPECT_FALSE(meet_sphere(camera.eye, {0, 0, 1})) << "behind the eye";

    // A point of the sphere, from there and from very far.
    for (double distance : {2.0, 1e3, 1e7}) {
        const Direction normal = normalised({0.3, -0.2, 0.9});
        const Direction eye = normal + distance * normalised({0.1, 0.4, 0.8});
        const auto hit = meet_sphere(eye, normalised(normal - eye));
        ASSERT_TRUE(hit) << distance;
        EXPECT_LT(angle(hit->normal, normal), 1e-15 * distance + 1e-14);
    }
}

TEST(Camera, CoversADiscOfPixels) {
    Camera camera;
    camera.width = camera.height = 48;
    double area = 0;
    for (int j = 0; j < 48; ++j)
        for (int i = 0; i < 48; ++i) area += coverage(camera, i, j, 16);
    const double radius = 24 * std::tan(std::asin(0.25)) / std::tan(15 * PI / 180);
    EXPECT_NEAR(area / (PI * radius * radius), 1, 1e-3);
    EXPECT_EQ(coverage(camera, 24, 24), 1);
    EXPECT_EQ(coverage(camera, 0, 0), 0);
}

TEST(ErrorMeasures, AreWhatTheySay) {
    const std::vector<double> exact{1, 3, 0, 4};
    const std::vector<double> actual{1, 3.3, 0.002, 4};
    const ErrorMeasures errors = measure_error(actual, exact);
    const double first = 0.3 / 3.002; // the mean is 2
    const double second = 1;
    EXPECT_NEAR(errors.pointwise_rms, std::sqrt((first * first + second * second) / 4), 1e-12);
    EXPECT_NEAR(errors.pointwise_max, second, 1e-12);
    EXPECT_NEAR(errors.image_rms, std::sqrt((0.09 + 4e-6) / 26), 1e-12);
    EXPECT_NEAR(errors.mean_ratio, 8.302 / 8, 1e-12);

    std::vector<double> many(10000, 1.0);
    const std::vector<double> ones = many;
    for (std::size_t i = 0; i < 10; ++i) many[i] = 2;
    EXPECT_EQ(measure_error(many, ones).pointwise_p999, 0);
    many[10] = 2;
    EXPECT_NEAR(measure_error(many, ones).pointwise_p999, 1 / 1.001, 1e-12);
    many[3] = std::nan("");
    EXPECT_TRUE(std::isnan(measure_error(many, ones).pointwise_max));

    const std::vector<double> black(4, 0.0);
    EXPECT_EQ(measure_error(black, black).pointwise_rms, 0);
    EXPECT_TRUE(std::isinf(measure_error(actual, black).pointwise_max));
}

TEST(RandomEnvironments, AreTheSameForTheSameSeed) {
    for (Scene scene : ALL_SCENES) {
        SCOPED_TRACE(name(scene));
        const Source first = random_panorama(scene, 32, 16, 5);
        EXPECT_EQ(first.texels(), random_panorama(scene, 32, 16, 5).texels());
        EXPECT_NE(first.texels(), random_panorama(scene, 32, 16, 6).texels());
        EXPECT_EQ(random_cube(scene, 8, 5).texels().size(), 6u * 64u);
        EXPECT_EQ(Source::panorama(32, 16, first.rgba()).texels(), first.texels());
        for (const Rgb& texel : first.texels())
            for (double channel : texel) EXPECT_TRUE(channel >= 0 && channel <= 1.1e9);
    }
}

TEST(RandomEnvironments, AskInEvenlySpreadDirections) {
    Random random(7);
    Direction sum{};
    for (int i = 0; i < 10000; ++i) {
        const Direction d = random.direction();
        EXPECT_NEAR(length(d), 1, 1e-14);
        sum = sum + d;
    }
    EXPECT_LT(length(sum) / 10000, 0.03); // three standard deviations
}

} // namespace
} // namespace lobelia::oracle
