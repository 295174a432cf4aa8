#pragma once

#include <lobelia/sphere.h>

namespace lobelia::cli {

/// Moves the eye around the target: `across` radians about `up`, then `over` towards it; stops
/// short of the poles.
void orbit(Camera& camera, double across, double over);

/// Brings the eye `factor` times as far from the target, but not into the sphere.
void move_eye(Camera& camera, double factor);

} // namespace lobelia::cli
