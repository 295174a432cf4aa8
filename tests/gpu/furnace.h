#pragma once

#include "sphere_fixture.h"

namespace lobelia::test {

/// Rays in 32 bits leave the cosine uncertain by 3e-7 over itself.
inline double furnace_tolerance(double cosine, double share) {
    return 1e-5 + (share > 0.0 ? 3e-7 / std::max(cosine, 1e-3) : 0.0);
}

/// Every pixel: kd + ks W(N.R, n), and 1 behind the sphere. Counts the pixels that lie on it.
inline int expect_furnace(const host::Image& picture, const SphereView& view) {
    const oracle::Camera camera = oracle_camera(view);
    const auto& [kd, ks, exponent] = view.material;
    int covered = 0;
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (std::uint32_t x = 0; x < view.width; ++x) {
            const auto hit = oracle::meet_sphere(camera.eye, ray(camera, x + 0.5, y + 0.5));
            const double cosine = hit ? dot(hit->normal, hit->view) : 0.0;
            const double share = double(picture.texel(0, x, y)[3]);
            const double albedo = share > 0.0 ? oracle::albedo(cosine, double(exponent)) : 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double surface = double(kd[c]) + double(ks[c]) * albedo;
                const double shown = double(picture.texel(0, x, y)[c]);
                EXPECT_NEAR(shown, share * surface + 1.0 - share, furnace_tolerance(cosine, share))
                    << text(view.camera) << " kd " << kd[c] << " ks " << ks[c] << " n " << exponent
                    << " pixel " << x << "," << y << " cosine " << cosine << " A " << share;
            }
            covered += share == 1.0;
        }
    return covered;
}

} // namespace lobelia::test
