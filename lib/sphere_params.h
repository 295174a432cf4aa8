#pragma once

#include <cmath>

#include <lobelia/lobe.h>

#include "camera_rays.h"

// What the sphere's shaders are told, made from a view.
namespace lobelia {

struct vec4 {
    float x, y, z, w;
};
#include "lobelia/sphere_params.glsl"
static_assert(sizeof(SphereParams) == 128);

inline vec4 to_vec4(Vector a, float w) {
    return {float(a.x), float(a.y), float(a.z), w};
}

inline SphereParams make_params(const SphereView& view) {
    const CameraRays rays = camera_rays(view);
    const auto& [kd, ks, exponent] = view.material;
    return {.direction = to_vec4(rays.centre, kd[0]),
            .direction_per_x = to_vec4(rays.per_x, kd[1]),
            .direction_per_y = to_vec4(rays.per_y, kd[2]),
            .moment = to_vec4(cross(rays.eye, rays.centre), ks[0]),
            .moment_per_x = to_vec4(cross(rays.eye, rays.per_x), ks[1]),
            .moment_per_y = to_vec4(cross(rays.eye, rays.per_y), ks[2]),
            .centre = to_vec4(-1.0 * rays.eye,
                              float(std::sqrt(std::max(dot(rays.eye, rays.eye) - 1.0, 0.0)))),
            .exponent = exponent,
            .width = view.width,
            .height = view.height,
            .background = view.background};
}

} // namespace lobelia
