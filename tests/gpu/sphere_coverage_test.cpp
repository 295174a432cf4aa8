#include <numbers>

#include "sphere_fixture.h"

// The share of each pixel that the sphere covers, against counting 64 x 64 rays, which leaves a few
// thousandths to chance.
namespace lobelia::test {
namespace {

class SphereCoverageTest : public SphereTest {
protected:
    host::Image draw_black(const SphereView& view) {
        return draw(black_, view); // alpha does not depend on the material
    }

    void expect_counted(const SphereView& view) {
        const host::Image picture = draw_black(view);
        const oracle::Camera camera = oracle_camera(view);
        const auto [low, size] = sphere_bounds(view);
        for (std::uint32_t y = 0; y < view.height; ++y)
            for (std::uint32_t x = 0; x < view.width; ++x) {
                const double shown = double(picture.texel(0, x, y)[3]);
                const double counted = oracle::coverage(camera, int(x), int(y));
                EXPECT_NEAR(shown, counted, 0.005)
                    << text(view.camera) << " pixel " << x << "," << y;
                const bool within =
                    x - std::uint32_t(low.x) < size.width && y - std::uint32_t(low.y) < size.height;
                EXPECT_TRUE(within || shown == 0.0)
                    << text(view.camera) << " pixel " << x << "," << y;
            }
    }

private:
    host::GpuEnvironment black_ = upload(even_panorama(2, 1, 0.0f, 0.0f, 0.0f));
};

TEST_F(SphereCoverageTest, LiesInBoundsThatFit) {
    // Seen from (0, 0, 4) the silhouette is a circle of the radius tan(asin(1/4)) at distance 1.
    const SphereView view{.width = 1280, .height = 720};
    const double radius = 1.0 / std::sqrt(15.0) * 360.0 / std::tan(std::numbers::pi / 12);
    const auto [low, size] = sphere_bounds(view);
    EXPECT_NEAR(low.x, 640.0 - radius, 3.0);
    EXPECT_NEAR(low.y, 360.0 - radius, 3.0);
    EXPECT_NEAR(size.width, 2.0 * radius, 6.0);
    EXPECT_NEAR(size.height, 2.0 * radius, 6.0);
}

TEST_F(SphereCoverageTest, IsWhatCountingRaysGives) {
    const Camera cameras[] = {
        {},
        {.eye = {0, 0, 4}, .target = {1.2f, 0.7f, 0}}, // off the middle
        {.eye = {0, 0, 1.5f},
         .target = {1, 0.3f, 0.5f},
         .vertical_field_of_view = 120.0f}, // stretched
        {.eye = {0, 0, 1.001f},
         .target = {3, 1, 0.5f},
         .vertical_field_of_view = 90.0f},                                // a horizon
        {.eye = {0, 0, 1.000001f}, .target = {3, 1, 1}, .up = {1, 3, 2}}, // a half space
        {.eye = {0, 0, 1.05f},
         .target = {2, 0.2f, 1.05f},
         .vertical_field_of_view = 160.0f},                       // behind, too
        {.eye = {0, 0, 1e6f}, .vertical_field_of_view = 1.5e-4f}, // far, far away
        {.eye = {6e5f, -5e5f, 7e5f}, .vertical_field_of_view = 4e-4f},
        {.eye = {0, 0, 100}, .vertical_field_of_view = 10.0f}, // 3 pixels in radius
    };
    for (const Camera& camera : cameras)
        expect_counted({.camera = camera, .width = 48, .height = 36});
}

TEST_F(SphereCoverageTest, IsWhatCountingRaysGivesFromRandomPlaces) {
    oracle::Random random(3);
    for (int i = 0; i < 10; ++i)
        expect_counted({.camera = random_camera(random), .width = 32, .height = 24});
}

TEST_F(SphereCoverageTest, KeepsTheAreaOfASphereSmallerThanAPixel) {
    // Seen from far away the sphere is a disc of radius cot(fov / 2) / distance half heights.
    for (const double radius : {2.0, 1.0, 0.5, 0.2, 0.05, 0.01}) { // pixels
        for (int i = 0; i < 8; ++i) {
            SphereView view{.width = 16, .height = 16};
            const double distance = 8.0 / radius / std::tan(15.0 * std::numbers::pi / 180.0);
            const double pixel = 1.0 / radius; // in radii, at the sphere
            view.camera.eye = {0, 0, float(distance)};
            view.camera.target = {float(0.31 * i * pixel), float((0.5 - 0.17 * i) * pixel), 0};
            const host::Image picture = draw_black(view);
            double area = 0.0;
            for (std::size_t t = 3; t < picture.texels.size(); t += 4)
                area += double(picture.texels[t]);
            const double expected = std::numbers::pi * radius * radius;
            EXPECT_NEAR(area, expected, 0.03 * expected) << "radius " << radius << " place " << i;
        }
    }
}

} // namespace
} // namespace lobelia::test
