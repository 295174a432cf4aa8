#include <cmath>
#include <numbers>

#include "bench.h"
#include "catalogue.h"
#include "host/checks.h"
#include "odd_floats.h"

// F: views of the sphere.
namespace lobelia::hard {
namespace {

constexpr std::uint32_t WIDTH = 24, HEIGHT = 16;

SphereView view_of(const Camera& camera, float n = 16) {
    return {
        .camera = camera, .material = test::grey(0.5f, 0.5f, n), .width = WIDTH, .height = HEIGHT};
}

// Every pixel that the sphere covers shows kd + ks W(N.R, n), every other what stands behind.
void furnace(const EvenSphere& sphere, Findings& found, const SphereView& view) {
    const host::Image picture = sphere.draw(view);
    found.sound(picture.texels);
    const oracle::Camera camera = test::oracle_camera(view);
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (std::uint32_t x = 0; x < view.width; ++x) {
            const double share = double(picture.texel(0, x, y)[3]);
            const auto hit = oracle::meet_sphere(camera.eye, ray(camera, x + 0.5, y + 0.5));
            const double cosine = hit ? dot(hit->normal, hit->view) : 0.0;
            const double surface =
                share > 0 ? 0.5 + 0.5 * oracle::albedo(cosine, double(view.material.exponent))
                          : 0.0;
            found.within(
                std::abs(double(picture.texel(0, x, y)[0]) - share * surface - (1 - share)),
                test::furnace_tolerance(cosine, share));
        }
}

void grazing(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, WIDTH, HEIGHT);
    for (float distance : {1.001f, 1.1f, 4.0f, 100.0f}) {
        // A narrow look at the silhouette.
        const double rim = std::asin(1.0 / double(distance));
        const float aside = float(double(distance) * std::tan(rim));
        for (float n : {0.0f, 1.0f, 64.0f, 1e6f}) {
            found.at("from " + text(distance) + ", n " + text(n));
            furnace(sphere, found,
                    view_of({.eye = {0, 0, distance},
                             .target = {aside, 0, 0},
                             .vertical_field_of_view = float(rim * 10)},
                            n));
        }
    }
}

void any_camera(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, WIDTH, HEIGHT);
    oracle::Random random(71);
    for (int i = 0; i < 25; ++i) {
        const Camera camera = test::random_camera(random);
        found.at(test::text(camera));
        furnace(sphere, found, view_of(camera, 4.8f));
    }
}

void on_the_surface(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, WIDTH, HEIGHT);
    for (const Camera& camera :
         {Camera{.eye = {0, 0, 1}},
          {.eye = {0, 0, 1}, .target = {0, 0, 2}},
          {.eye = {0, 0, 1}, .target = {1, 0, 1}, .vertical_field_of_view = 170}}) {
        found.at(test::text(camera));
        const host::Image picture = sphere.draw(view_of(camera));
        found.sound(picture.texels);
        for (float value : picture.texels) found.holds(value <= 1.00001f, "no more than the light");
    }
}

// The view, spoiled, is refused.
void spoiled(Bench& bench, Findings& found, const std::string& where, const SphereView& view,
             const std::string& words) {
    found.at(where);
    const auto refused = host::check_view(view, bench.gpu().limits());
    found.refused(refused ? refused->message : "", words);
}

void inside(Bench& bench, Findings& found) {
    for (float z : {0.999f, 0.5f, 1e-30f})
        spoiled(bench, found, "eye at " + text(z), view_of({.eye = {0, 0, z}}), "inside");
}
void at_the_centre(Bench& bench, Findings& found) {
    spoiled(bench, found, "eye at 0", view_of({.eye = {0, 0, 0}, .target = {0, 0, 1}}), "inside");
}

void far_away(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, WIDTH, HEIGHT, false);
    for (float distance : {1e2f, 1e4f, 1e6f, 1e8f}) {
        found.at("from " + text(distance));
        SphereView view = view_of(
            {.eye = {0, 0, distance},
             .target = {0.3f, 0.2f, 0},
             .vertical_field_of_view = float(3.2 / double(distance) * 180 / std::numbers::pi)});
        view.background = false;
        const host::Image picture = sphere.draw(view);
        found.sound(picture.texels);
        const oracle::Camera camera = test::oracle_camera(view);
        for (int y = 0; y < int(HEIGHT); ++y)
            for (int x = 0; x < int(WIDTH); ++x) // 16 x 16 points miss an area by their edges
                found.within(std::abs(double(picture.texel(0, unsigned(x), unsigned(y))[3]) -
                                      oracle::coverage(camera, x, y, 16)),
                             2.0 / 16);
    }
}

void bad_cameras(Bench& bench, Findings& found) {
    for (float bad : {NOT_A_NUMBER, INFINITE, -INFINITE})
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Camera eye, target, up;
            eye.eye[axis] = target.target[axis] = up.up[axis] = bad;
            const std::string where = text(bad) + " in axis " + std::to_string(axis);
            spoiled(bench, found, where + " of the eye", view_of(eye), "eye");
            spoiled(bench, found, where + " of the target", view_of(target), "target");
            spoiled(bench, found, where + " of up", view_of(up), "up");
        }
    spoiled(bench, found, "nowhere to look", view_of({.eye = {0, 0, 4}, .target = {0, 0, 4}}),
            "another point");
    spoiled(bench, found, "up along the view", view_of({.up = {0, 0, 3}}), "another direction");
    spoiled(bench, found, "no up", view_of({.up = {0, 0, 0}}), "another direction");
}

void fields_of_view(Bench& bench, Findings& found) {
    for (float angle : {0.0f, -0.0f, -30.0f, 180.0f, 360.0f, NOT_A_NUMBER, INFINITE})
        spoiled(bench, found, text(angle) + " degrees", view_of({.vertical_field_of_view = angle}),
                "field of view");
    const EvenSphere sphere(bench, WIDTH, HEIGHT);
    for (float angle : {1e-4f, 1.0f, 179.0f, 179.9999f}) {
        found.at(text(angle) + " degrees");
        found.sound(sphere.draw(view_of({.vertical_field_of_view = angle})).texels);
    }
}

void sizes(Bench& bench, Findings& found) {
    const std::uint32_t most = bench.gpu().limits().maxImageDimension2D;
    for (auto [width, height] : {std::pair{0u, 4u}, {4u, 0u}, {most + 1, 4u}, {4u, 4000000000u}}) {
        SphereView view = view_of({});
        view.width = width;
        view.height = height;
        spoiled(bench, found, std::to_string(width) + " x " + std::to_string(height), view,
                "picture's size");
    }
    for (auto [width, height] : {std::pair{1u, 1u}, {1u, 8192u}}) {
        found.at(std::to_string(width) + " x " + std::to_string(height));
        const EvenSphere sphere(bench, width, height);
        found.sound(sphere.draw(view_of({})).texels);
    }
}

void aspects(Bench& bench, Findings& found) {
    for (auto [width, height] : {std::pair{10000u, 1u}, {1u, 10000u}}) {
        const EvenSphere sphere(bench, width, height);
        for (float angle : {30.0f, 179.9f}) {
            found.at(std::to_string(width) + " x " + std::to_string(height) + " of " + text(angle) +
                     " degrees");
            const host::Image picture = sphere.draw(view_of({.vertical_field_of_view = angle}));
            found.sound(picture.texels);
        }
    }
}

void whole_turns(Bench& bench, Findings& found) {
    // Six colours: what a turn moves shows.
    const host::GpuImage colours =
        test::on_device(bench.gpu(), image_of(oracle::cube_of(16, [](Direction d) {
                            return Rgb{1 + d.x, 1 + d.y, 1 + d.z};
                        })));
    const test::SpherePicture picture(bench.gpu(), WIDTH, HEIGHT, {});
    const SphereSources sources{
        .background = colours.view(), .diffuse = colours.view(), .specular = colours.view()};
    SphereView view = view_of({.eye = {1, 2, 3}});
    const host::Image still = picture.draw(sources, view);
    for (int turns : {-100, -1, 1, 7, 1000}) {
        found.at(std::to_string(turns) + " turns");
        view.environment_rotation = float(2 * std::numbers::pi * turns);
        const host::Image turned = picture.draw(sources, view);
        // The angle is a 32-bit number, and fetches take it to a texel's 256th.
        const double allowed =
            double(std::abs(view.environment_rotation)) * 0x1p-24 + 1.0 / 8 / 256;
        for (std::size_t i = 0; i < still.texels.size(); ++i)
            found.within(std::abs(double(turned.texels[i]) - double(still.texels[i])), allowed);
    }
    for (float bad : {NOT_A_NUMBER, INFINITE}) {
        view.environment_rotation = bad;
        spoiled(bench, found, text(bad) + " turns", view, "rotation");
    }
}

} // namespace

Kind views() {
    return {
        "Views",
        {
            {"F01", "grazing views of the silhouette from 1.001 to 100 radii",
             "kd + ks W(N.R, n) at every pixel", grazing},
            {"F02", "normals that face away", "no pixel has one", nullptr, nullptr,
             "the sphere is cast as a ray, whose nearer meeting faces the eye; what an engine's "
             "own "
             "surfaces give shade() is the engine's"},
            {"F03", "silhouettes from 25 random cameras",
             "sphere, background or their blend by coverage, never anything else", any_camera},
            {"F04", "the eye on the surface", "finite, no more than the light", on_the_surface},
            {"F05", "the eye inside the sphere", "refused", inside},
            {"F06", "the eye at the centre", "refused", at_the_centre},
            {"F07", "radius 0, negative, NaN, 1e-30, 1e30", "there is no radius", nullptr, nullptr,
             "the sphere is the unit sphere at the origin; distance does what size would"},
            {"F08", "the eye 1e2 to 1e8 radii away", "coverage is what counting rays gives",
             far_away},
            {"F09", "NaN, infinity, parallel and equal vectors in the camera",
             "refused, naming the vector", bad_cameras},
            {"F10", "fields of view of 0, 180, more, less, NaN; 1e-4 and 179.9999 degrees",
             "refused; finite", fields_of_view},
            {"F11", "pictures of 0 x 4, beyond the device, 1 x 1, 1 x 8192", "refused; finite",
             sizes},
            {"F12", "pictures of 10000 x 1 and 1 x 10000", "finite", aspects},
            {"F13", "normals that cannot be normalised", "none: every pixel is finite", nullptr,
             "SphereTest.GivesFiniteTexelsFromEveryPlace"},
            {"F14", "whole turns of the environment, up to 1000; NaN and infinity",
             "the picture stays, to the angle's last digit; refused", whole_turns},
        }};
}

} // namespace lobelia::hard
