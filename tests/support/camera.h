#pragma once

#include <optional>

#include "support/direction.h"

namespace lobelia::oracle {

/// A pinhole camera that looks at the unit sphere around the origin. Positions in sphere radii.
struct Camera {
    Direction eye{0, 0, 4};       // a position
    Direction target{0, 0, 0};    // a position
    Direction up{0, 1, 0};        // need not be across the view
    double vertical_degrees = 30; // field of view
    int width = 512;
    int height = 512;
};

/// Direction from the eye through the point (x, y) of the image, in pixels from the top left
/// corner: the middle of pixel (i, j) is (i + 0.5, j + 0.5).
Direction ray(const Camera& camera, double x, double y);

/// Where a ray meets the sphere: the normal, which is the point, and the direction to the eye.
struct Hit {
    Direction normal;
    Direction view;
};

/// The nearer meeting of the unit sphere with the ray from `eye` along the unit vector `along`, in
/// front of the eye; nothing where it passes by. Exact to rounding from 1e8 radii away, too.
std::optional<Hit> meet_sphere(Direction eye, Direction along);

/// The share of the pixel (i, j) that the sphere covers, from side x side points.
double coverage(const Camera& camera, int i, int j, int side = 64);

} // namespace lobelia::oracle
