#include "pick.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vector.h"

namespace lobelia::cli {

std::optional<SurfaceDirections> surface_at(const SphereView& view, std::uint32_t x,
                                            std::uint32_t y) {
    const Vector eye = view.camera.eye;
    const Vector forward = normalised(Vector(view.camera.target) - eye);
    const Vector right = normalised(cross(forward, Vector(view.camera.up)));
    const Vector down = cross(forward, right);
    const double pixel =
        2.0 * std::tan(view.camera.vertical_field_of_view * std::numbers::pi / 360.0) / view.height;
    const Vector direction = normalised(forward + pixel * (x + 0.5 - 0.5 * view.width) * right +
                                        pixel * (y + 0.5 - 0.5 * view.height) * down);
    const double along = dot(eye, direction);
    const double discriminant = along * along - dot(eye, eye) + 1.0;
    const double distance = -along - std::sqrt(std::max(discriminant, 0.0));
    if (discriminant < 0.0 || distance < 0.0) return std::nullopt;
    const Vector normal = normalised(eye + distance * direction);
    const Vector mirror = direction - 2.0 * dot(direction, normal) * normal;
    return SurfaceDirections{normal.floats(), mirror.floats()};
}

float relative_error(const Pick& pick) {
    float largest = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        if (const float difference = std::abs(pick.shown[c] - pick.exact[c]); difference > 0.0f)
            largest = std::max(largest, difference / std::max(pick.exact[c], 1e-30f));
    return largest;
}

} // namespace lobelia::cli
