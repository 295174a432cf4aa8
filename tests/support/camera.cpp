#include "support/camera.h"

namespace lobelia::oracle {

Direction ray(const Camera& camera, double x, double y) {
    const Direction forward = normalised(camera.target - camera.eye);
    const Direction right = normalised(cross(forward, camera.up));
    const Direction up = cross(right, forward);
    const double half = std::tan(0.5 * camera.vertical_degrees * PI / 180);
    const double pixel = 2 * half / camera.height;
    return normalised(forward + (x - 0.5 * camera.width) * pixel * right -
                      (y - 0.5 * camera.height) * pixel * up);
}

std::optional<Hit> meet_sphere(Direction eye, Direction along) {
    // The point of the ray nearest to the centre, free of the cancellation of b^2 - 4ac.
    const Direction nearest = cross(along, cross(eye, along));
    const double inside = 1 - dot(nearest, nearest);
    if (inside < 0) return {};
    const double before = std::sqrt(inside);
    if (-dot(eye, along) - before <= 0) return {};
    return Hit{normalised(nearest - before * along), -1.0 * along};
}

double coverage(const Camera& camera, int i, int j, int side) {
    int met = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (meet_sphere(camera.eye, ray(camera, i + (x + 0.5) / side, j + (y + 0.5) / side)))
                ++met;
    return double(met) / (side * side);
}

} // namespace lobelia::oracle
