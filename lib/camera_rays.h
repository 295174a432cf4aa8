#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <lobelia/sphere.h>

// Rays of a camera in double precision: for the pass that draws the sphere, and for the host, which
// computes what that pass will look up.
namespace lobelia {

struct Vector {
    double x = 0, y = 0, z = 0;
};
constexpr Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector operator*(double s, Vector a) {
    return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vector a) {
    return std::sqrt(dot(a, a));
}
inline Vector normalised(Vector a) {
    return (1.0 / std::max(length(a), 1e-300)) * a;
}
inline Vector to_vector(const std::array<float, 3>& a) {
    return {a[0], a[1], a[2]};
}

/// The ray through the point (x, y) of the image, in pixels right and down from its centre, is
/// eye + t (centre + x per_x + y per_y).
struct CameraRays {
    Vector eye, centre, per_x, per_y;

    Vector direction(double x, double y) const { return centre + x * per_x + y * per_y; }
};

/// The sphere looks the same from all sides, so turning the environment one way is turning the
/// camera the other way: these rays are in the frame of the environment's own image.
inline CameraRays camera_rays(const SphereView& view) {
    const double cosine = std::cos(double(view.environment_rotation));
    const double sine = std::sin(double(view.environment_rotation));
    const auto turned = [=](Vector a) -> Vector {
        return {cosine * a.x - sine * a.z, a.y, sine * a.x + cosine * a.z};
    };
    const Camera& camera = view.camera;
    const Vector eye = to_vector(camera.eye);
    const Vector forward = normalised(to_vector(camera.target) - eye);
    const Vector right = normalised(cross(forward, to_vector(camera.up)));
    const Vector down = cross(forward, right);
    const double half_angle = camera.vertical_field_of_view * std::numbers::pi / 360.0;
    const double pixel = 2.0 * std::tan(half_angle) / view.height;
    return {turned(eye), turned(forward), pixel * turned(right), pixel * turned(down)};
}

} // namespace lobelia
