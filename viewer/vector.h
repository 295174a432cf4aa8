#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace lobelia::cli {

/// A vector of three numbers, for the camera.
struct Vector {
    double x = 0, y = 0, z = 0;

    Vector(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
    Vector(const std::array<float, 3>& a) : x(a[0]), y(a[1]), z(a[2]) {}
    std::array<float, 3> floats() const { return {float(x), float(y), float(z)}; }
};
inline Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, Vector a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(Vector a, Vector b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vector a) {
    return std::sqrt(dot(a, a));
}
inline Vector normalised(Vector a) {
    return 1.0 / std::max(length(a), 1e-300) * a;
}
/// `a` turned about the unit vector `axis`, counter-clockwise seen from its tip.
inline Vector turned(Vector a, Vector axis, double radians) {
    const double c = std::cos(radians), s = std::sin(radians);
    return c * a + s * cross(axis, a) + (1.0 - c) * dot(axis, a) * axis;
}

} // namespace lobelia::cli
