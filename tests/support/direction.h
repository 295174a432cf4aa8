#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace lobelia::oracle {

inline constexpr double PI = std::numbers::pi;

/// A vector of the world: right-handed, +Y up. A unit vector unless the name says otherwise.
struct Direction {
    double x = 0;
    double y = 0;
    double z = 0;
};

/// Linear radiance, red green blue.
using Rgb = std::array<double, 3>;

constexpr Direction operator+(Direction a, Direction b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Direction operator-(Direction a, Direction b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Direction operator*(double s, Direction a) {
    return {s * a.x, s * a.y, s * a.z};
}

constexpr double dot(Direction a, Direction b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Direction cross(Direction a, Direction b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Direction a) {
    return std::sqrt(dot(a, a));
}
inline Direction normalised(Direction a) {
    return (1.0 / length(a)) * a;
}

/// Where light that leaves towards `view` comes from on a mirror of normal `normal`.
constexpr Direction mirror(Direction normal, Direction view) {
    return 2.0 * dot(normal, view) * normal - view;
}

/// Angle between two unit vectors in radians, accurate near 0 and near pi too.
inline double angle(Direction a, Direction b) {
    return 2.0 * std::atan2(length(a - b), length(a + b));
}

} // namespace lobelia::oracle
