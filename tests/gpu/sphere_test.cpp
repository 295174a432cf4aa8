#include "furnace.h"

// What the sphere shows, against closed forms and the double-precision camera.
namespace lobelia::test {
namespace {

using oracle::Direction;

/// Constant light of radiance 1: what every map of it holds, whatever the lobe.
struct White {
    explicit White(host::Gpu& gpu)
        : cube(on_device(gpu, {host::Layout::cube, 1, 1, 6, std::vector<float>(24, 1.0f)})) {}
    SphereSources sources() const {
        return {.background = cube.view(), .diffuse = cube.view(), .specular = cube.view()};
    }
    host::GpuImage cube;
};

TEST_F(SphereTest, ShowsTheAlbedoInConstantLight) {
    const White white(gpu);
    const SpherePicture pass(gpu, 36, 24, {});
    oracle::Random random(7);
    int covered = 0;
    for (int i = 0; i < 100; ++i) {
        SphereView view{.camera = random_camera(random), .width = 36, .height = 24};
        for (const float exponent : {0.0f, 4.8f, 64.0f, 1e6f}) {
            for (std::size_t c = 0; c < 3; ++c) {
                view.material.diffuse[c] = float(random.unit());
                view.material.specular[c] = 1.0f - view.material.diffuse[c];
            }
            view.material.exponent = exponent;
            covered += expect_furnace(pass.draw(white.sources(), view), view);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(covered, 80'000);
}

/// An environment in which direction d has the radiance (2 + d) / 3, large enough for a shift by
/// half a texel, which changes that by 1e-3, to stand out: a face's texel that cuts one of the
/// panorama's is off by up to an eighth of the step between those, 2.6e-4, and linear filtering by
/// 1e-5.
oracle::Rgb radiance_of(Direction d) {
    return {(2 + d.x) / 3, (2 + d.y) / 3, (2 + d.z) / 3};
}

host::Image slope_panorama() {
    return image_of(oracle::panorama_of(1024, 512, radiance_of));
}

// Where light from `d` stands in an environment turned by `angle` about +Y.
Direction turned(Direction d, double angle) {
    return {std::cos(angle) * d.x + std::sin(angle) * d.z, d.y,
            std::cos(angle) * d.z - std::sin(angle) * d.x};
}

SphereView orientation_view(oracle::Random& random, int i) {
    SphereView view{.camera = random_camera(random), .width = 40, .height = 30};
    view.camera.vertical_field_of_view = 70.0f;
    view.environment_rotation = i % 3 == 0 ? 0.0f : float(random.between(-4.0, 4.0));
    return view;
}

TEST_F(SphereTest, ShowsTheEnvironmentBehindItTheRightWayRound) {
    const host::GpuEnvironment environment = upload(slope_panorama());
    oracle::Random random(1);
    for (int i = 0; i < 12; ++i) {
        const SphereView view = orientation_view(random, i); // black: only the background is seen
        const host::Image picture = draw(environment, view);
        for (std::uint32_t y = 0; y < view.height; ++y)
            for (std::uint32_t x = 0; x < view.width; ++x) {
                const Direction along = ray(oracle_camera(view), x + 0.5, y + 0.5);
                const oracle::Rgb expected =
                    radiance_of(turned(along, -double(view.environment_rotation)));
                const float* const pixel = picture.texel(0, x, y);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(pixel[c], (1.0 - double(pixel[3])) * expected[std::size_t(c)], 4e-4)
                        << text(view.camera) << " rotation " << view.environment_rotation
                        << " pixel " << x << "," << y << " channel " << c;
            }
    }
}

TEST_F(SphereTest, ReflectsTheEnvironmentTheRightWayRound) {
    // Funk-Hecke: a lobe of exponent n scales the linear part by (n + 1) / (n + 2).
    const host::GpuEnvironment environment = upload(slope_panorama());
    oracle::Random random(2);
    for (int i = 0; i < 6; ++i) {
        SphereView view = orientation_view(random, i);
        view.background = false;
        const bool diffuse = i % 2 == 0;
        view.material = diffuse ? grey(1.0f, 0.0f, 64.0f) : grey(0.0f, 1.0f, 64.0f);
        const double shrink = diffuse ? 2.0 / 3.0 : 65.0 / 66.0;
        const host::Image picture = draw(environment, view);
        const oracle::Camera camera = oracle_camera(view);
        for (std::uint32_t y = 0; y < view.height; ++y)
            for (std::uint32_t x = 0; x < view.width; ++x) {
                const float* const pixel = picture.texel(0, x, y);
                const auto hit = oracle::meet_sphere(camera.eye, ray(camera, x + 0.5, y + 0.5));
                if (!hit || pixel[3] < 1.0f) continue;
                const Direction axis =
                    diffuse ? hit->normal : oracle::mirror(hit->normal, hit->view);
                const oracle::Rgb expected =
                    radiance_of(shrink * turned(axis, -double(view.environment_rotation)));
                const double albedo =
                    diffuse ? 1.0 : oracle::albedo(dot(hit->normal, hit->view), 64.0);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(pixel[c], albedo * expected[std::size_t(c)], 2e-3)
                        << text(view.camera) << " rotation " << view.environment_rotation
                        << " pixel " << x << "," << y << " channel " << c;
            }
    }
}

TEST_F(SphereTest, IsTransparentBlackWhereThereIsNoSphereAndNoBackground) {
    const host::GpuEnvironment white = upload(even_panorama(8, 4, 1.0f, 1.0f, 1.0f));
    const SphereView view{
        .material = grey(1.0f, 0.0f, 1.0f), .background = false, .width = 64, .height = 48};
    const host::Image picture = draw(white, view);
    for (std::size_t i = 0; i < picture.texels.size(); i += 4) {
        const float share = picture.texels[i + 3];
        ASSERT_NEAR(picture.texels[i], share, 1e-6) << "pixel " << i / 4;
        if (share == 0.0f) {
            ASSERT_EQ(picture.texels[i], 0.0f) << "pixel " << i / 4;
        }
    }
    EXPECT_EQ(picture.texel(0, 0, 0)[3], 0.0f);
    EXPECT_EQ(picture.texel(0, 32, 24)[3], 1.0f);
}

TEST_F(SphereTest, GivesFiniteTexelsFromEveryPlace) {
    struct Place {
        Camera camera;
        std::uint32_t width, height;
    };
    const Place places[] = {
        {{.eye = {0, 0, 1}}, 33, 21},                                          // on it
        {{.eye = {0, 0, 1}, .target = {5, 0, 1}}, 33, 21},                     // along it
        {{.eye = {0, 0, 1}, .target = {0, 0, 9}}, 33, 21},                     // away
        {{.eye = {0.6f, 0.8f, 0}, .vertical_field_of_view = 179.99f}, 33, 21}, // all around
        {{.eye = {0, 0, 1.0000002f}, .target = {1, 0, 1}}, 33, 21},            // grazing
        {{.eye = {0, 0, 4}, .vertical_field_of_view = 1e-30f}, 9, 9},          // one point
        {{.eye = {0, 1, 4}, .target = {0, 1, 0}, .vertical_field_of_view = 1e-4f}, 9, 9}, // the rim
        {{.eye = {0, 0, 1e6f}}, 33, 21},                                                  // a speck
        {{.eye = {0, 0, 1e6f}, .vertical_field_of_view = 1.5e-4f}, 33, 21},
        {{.eye = {3e5f, 8e5f, 5e5f}, .target = {1e6f, 0, 0}, .vertical_field_of_view = 179.0f},
         33,
         21},
        {{.eye = {0, 0, 1e9f}, .vertical_field_of_view = 179.9999f}, 1, 1},
        {{.eye = {0, 0, 4}}, 1, 1},
        {{.eye = {0, 0, 4}}, 4096, 1},
        {{.eye = {0, 0, 4}, .vertical_field_of_view = 179.9999f}, 4096, 1},
        {{.eye = {0, 0, 4}}, 1, 4096},
        {{.eye = {0, 0, 4}, .target = {0, 0, 3e38f}}, 9, 9},
        {{.eye = {0, 0, 4}, .up = {1e-38f, 1e-38f, 0}}, 9, 9},
    };
    const host::GpuEnvironment white = upload(even_panorama(8, 4, 1.0f, 1.0f, 1.0f));
    for (const Place& place : places)
        for (const bool background : {false, true}) {
            const SphereView view{.camera = place.camera,
                                  .material = grey(0.5f, 0.5f, 16.0f),
                                  .background = background,
                                  .width = place.width,
                                  .height = place.height};
            const host::Image picture = draw(white, view);
            for (std::size_t i = 0; i < picture.texels.size(); ++i)
                ASSERT_TRUE(picture.texels[i] >= 0.0f && picture.texels[i] <= 1.00001f)
                    << text(place.camera) << " texel " << i / 4 << " is " << picture.texels[i];
        }
}

TEST_F(SphereTest, RefusesWhatItCannotDraw) {
    const host::GpuEnvironment white = upload(even_panorama(2, 1, 1.0f, 1.0f, 1.0f));
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const SphereView good{.material = grey(0.5f, 0.5f, 1.0f), .width = 4, .height = 4};
    const auto message = [&](const std::function<void(SphereView&)>& spoil) {
        SphereView view = good;
        spoil(view);
        const auto rendering = host::render(gpu, white, {.view = view});
        return rendering ? std::string("accepted") : rendering.error().message;
    };
    EXPECT_EQ(message([](SphereView&) {}), "accepted");
    EXPECT_EQ(message([](SphereView& v) { v.width = 0; }),
              "the picture's size is 0x4, give 1x1 to 16384x16384");
    EXPECT_EQ(message([](SphereView& v) { v.height = 16385; }),
              "the picture's size is 4x16385, give 1x1 to 16384x16384");
    EXPECT_EQ(message([](SphereView& v) {
                  v.camera.eye = {0, 0, 0.5f};
              }),
              "eye 0,0,0.5 is inside the sphere of radius 1 about 0,0,0, move it out");
    EXPECT_EQ(message([](SphereView& v) {
                  v.camera.eye = {0, 0, 2e9f};
              }),
              "eye 0,0,2e+09 is more than 1000000000 radii from the sphere, move it closer");
    EXPECT_EQ(message([=](SphereView& v) {
                  v.camera.eye = {0, nan, 4};
              }),
              "eye is 0,nan,4, give finite numbers");
    EXPECT_EQ(message([](SphereView& v) { v.camera.target = v.camera.eye; }),
              "eye and target are both 0,0,4, look at another point");
    EXPECT_EQ(message([](SphereView& v) {
                  v.camera.up = {0, 0, -2};
              }),
              "up 0,0,-2 is 0 or along the line of sight, give another direction");
    for (const float angle : {0.0f, -1.0f, 180.0f, nan})
        EXPECT_NE(message([=](SphereView& v) {
                      v.camera.vertical_field_of_view = angle;
                  }).find("degrees, give more than 0 and less than 180"),
                  std::string::npos);
    EXPECT_EQ(message([=](SphereView& v) { v.environment_rotation = infinity; }),
              "the environment's rotation is inf, give a finite angle");
    EXPECT_EQ(message([](SphereView& v) { v.material.exponent = 1.5e6f; }),
              "the exponent n is 1500000, give a number from 0 to 1000000");
    EXPECT_EQ(message([](SphereView& v) { v.material.diffuse[1] = -0.25f; }),
              "kd is -0.25 in the green channel, give a number from 0 to 1");
    EXPECT_EQ(
        host::check_material(grey(0.75f, 0.5f, 1.0f), false)->message,
        "kd + ks is 0.75 + 0.5 = 1.25 in the red channel, more light than comes in: lower one "
        "of them, or pass --allow-energy-gain");
    EXPECT_FALSE(host::check_material(grey(0.75f, 0.5f, 1.0f), true));
    EXPECT_FALSE(host::check_material(grey(0.7f, 0.3f, 1.0f), false));
}

} // namespace
} // namespace lobelia::test
