#include <lobelia/sphere.h>

#include "camera_rays.h"

namespace lobelia {

namespace {

struct Range {
    std::uint32_t first = 0, count = 0;
};

// Along one axis of the picture, of `size` pixels: where the planes through the eye that touch the
// sphere cut the image plane. `across` and `ahead` is the sphere's middle as the camera sees it,
// `pixel` a pixel's edge at distance 1.
Range range(double across, double ahead, double pixel, std::uint32_t size) {
    constexpr double MARGIN = 2.0; // pixels: partly covered ones, and rounding in the shader
    const double distance = std::hypot(across, ahead);
    double low = 0.0, high = size;
    if (distance > 1.0) {
        const double middle = std::atan2(across, ahead), half = std::asin(1.0 / distance);
        const double right_angle = 0.5 * std::numbers::pi;
        if (middle - half > -right_angle && middle - half < right_angle)
            low = std::tan(middle - half) / pixel + 0.5 * size - MARGIN;
        if (middle + half < right_angle && middle + half > -right_angle)
            high = std::tan(middle + half) / pixel + 0.5 * size + MARGIN;
        // A touching plane that does not meet the image ahead leaves that side open.
    }
    const double first = std::floor(std::clamp(low, 0.0, double(size)));
    const double end = std::ceil(std::clamp(high, 0.0, double(size)));
    return {std::uint32_t(first), std::uint32_t(std::max(end - first, 0.0))};
}

} // namespace

VkRect2D sphere_bounds(const SphereView& view) noexcept {
    const CameraRays rays = camera_rays(view);
    const Vector middle = -1.0 * rays.eye;
    const double pixel_x = length(rays.per_x), pixel_y = length(rays.per_y);
    const double ahead = dot(middle, rays.centre);
    const Range x = range(dot(middle, rays.per_x) / pixel_x, ahead, pixel_x, view.width);
    const Range y = range(dot(middle, rays.per_y) / pixel_y, ahead, pixel_y, view.height);
    return {{std::int32_t(x.first), std::int32_t(y.first)}, {x.count, y.count}};
}

} // namespace lobelia
