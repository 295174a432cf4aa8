#include "orbit.h"

#include <algorithm>
#include <cmath>

#include "vector.h"

namespace lobelia::cli {

namespace {

constexpr double STEEPEST = 1.55;   // radians above and below the horizon; pi / 2 is 1.57
constexpr double NEAREST = 1.05;    // radii from the sphere's centre
constexpr double FARTHEST = 1000.0; // radii from the target

void place_eye(Camera& camera, Vector eye) {
    if (length(eye) >= NEAREST) camera.eye = eye.floats();
}

} // namespace

void orbit(Camera& camera, double across, double over) {
    const Vector target = camera.target, up = normalised(camera.up);
    const Vector from_target = Vector(camera.eye) - target;
    const double distance = length(from_target);
    const double height = std::asin(std::clamp(dot(from_target, up) / distance, -1.0, 1.0));
    const double new_height = std::clamp(height + over, -STEEPEST, STEEPEST);
    const Vector level = from_target - dot(from_target, up) * up;
    const Vector ahead = turned(normalised(level), up, across);
    place_eye(camera,
              target + distance * (std::cos(new_height) * ahead + std::sin(new_height) * up));
}

void move_eye(Camera& camera, double factor) {
    const Vector target = camera.target;
    const Vector from_target = Vector(camera.eye) - target;
    const double distance = std::min(factor * length(from_target), FARTHEST);
    place_eye(camera, target + distance * normalised(from_target));
}

} // namespace lobelia::cli
