#include "host/camera.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <lobelia/host/scene_maps.h>

#include "camera_rays.h"
#include "host/checks.h"
#include "host/text.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LARGEST_PICTURE = 16384;
constexpr double FARTHEST_EYE = 1e9;     // radii; 32-bit squares of squares end soon after
constexpr double LEAST_EYE = 1.0 - 1e-6; // on the sphere but for rounding
constexpr double PARALLEL = 1e-6;        // sine of an angle that a 32-bit vector cannot resolve

std::optional<Failure> check_size(const SphereView& view, const VkPhysicalDeviceLimits& limits) {
    const std::uint32_t width =
        std::min({LARGEST_PICTURE, limits.maxImageDimension2D, limits.maxFramebufferWidth,
                  limits.maxViewportDimensions[0]});
    const std::uint32_t height =
        std::min({LARGEST_PICTURE, limits.maxImageDimension2D, limits.maxFramebufferHeight,
                  limits.maxViewportDimensions[1]});
    if (view.width >= 1 && view.height >= 1 && view.width <= width && view.height <= height)
        return std::nullopt;
    return Failure{"the picture's size is " + std::to_string(view.width) + "x" +
                   std::to_string(view.height) + ", give 1x1 to " + std::to_string(width) + "x" +
                   std::to_string(height)};
}

std::optional<Failure> check_finite(const char* name, const std::array<float, 3>& value) {
    if (std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]))
        return std::nullopt;
    return Failure{std::string(name) + " is " + vector_text(value) + ", give finite numbers"};
}

std::optional<Failure> check_camera(const Camera& camera) {
    if (auto refused = check_finite("eye", camera.eye)) return refused;
    if (auto refused = check_finite("target", camera.target)) return refused;
    if (auto refused = check_finite("up", camera.up)) return refused;
    const float angle = camera.vertical_field_of_view;
    if (!(angle > 0.0f && angle < 180.0f))
        return Failure{"the field of view is " + number_text(angle) +
                       " degrees, give more than 0 and less than 180"};

    const Vector eye = to_vector(camera.eye);
    const Vector towards = to_vector(camera.target) - eye;
    const Vector up = to_vector(camera.up);
    if (length(eye) < LEAST_EYE)
        return Failure{"eye " + vector_text(camera.eye) +
                       " is inside the sphere of radius 1 about 0,0,0, move it out"};
    if (length(eye) > FARTHEST_EYE)
        return Failure{"eye " + vector_text(camera.eye) +
                       " is more than 1000000000 radii from the sphere, move it closer"};
    if (length(towards) == 0.0)
        return Failure{"eye and target are both " + vector_text(camera.eye) +
                       ", look at another point"};
    if (length(cross(normalised(towards), normalised(up))) < PARALLEL)
        return Failure{"up " + vector_text(camera.up) +
                       " is 0 or along the line of sight, give another direction"};
    return std::nullopt;
}

/// The ray through a pixel's centre, as in shaders/lobelia/sphere.glsl.
struct Ray {
    Vector direction, moment;
};

/// What decides whether the ray meets the sphere: |direction|^2 - |moment|^2 at the pixel's centre,
/// as the difference of two lengths, and an upper limit of the difference's change to its corners.
struct Margin {
    double value, reach;
    bool in_front;
};

Margin margin(const CameraRays& rays, const Ray& ray) {
    const double moment_per_pixel =
        length(cross(rays.eye, rays.per_x)) + length(cross(rays.eye, rays.per_y));
    return {length(ray.direction) - length(ray.moment),
            0.5 * (length(rays.per_x) + length(rays.per_y) + moment_per_pixel),
            dot(rays.eye, ray.direction) < 0.0};
}

// A pixel more or less by rounding costs nothing; one too few would show.
bool may_be_covered(const Margin& margin) {
    const double reach = 1.001 * margin.reach + 1e-6;
    return margin.value > -reach && (margin.in_front || margin.value < reach);
}

SpherePixel sphere_pixel(const CameraRays& rays, const Ray& ray, const Margin& margin,
                         std::uint32_t index) {
    const double stretch = length(ray.direction);
    const Vector direction = 1.0 / stretch * ray.direction;
    const Vector nearest = 1.0 / stretch * cross(direction, ray.moment);
    double cosine = 0.0;
    if (margin.in_front && margin.value > 0.0)
        cosine = std::sqrt(margin.value * (stretch + length(ray.moment))) / stretch;
    Vector normal = nearest - cosine * direction;
    normal = length(normal) > 1e-3 ? normalised(normal) : normalised(rays.eye);
    const Vector mirror = normalised(direction + 2.0 * cosine * normal);
    return {index,
            {float(normal.x), float(normal.y), float(normal.z)},
            {float(mirror.x), float(mirror.y), float(mirror.z)}};
}

} // namespace

std::optional<Failure> check_view(const SphereView& view, const VkPhysicalDeviceLimits& limits) {
    if (auto refused = check_size(view, limits)) return refused;
    if (auto refused = check_camera(view.camera)) return refused;
    if (std::isfinite(view.environment_rotation)) return std::nullopt;
    return Failure{"the environment's rotation is " + number_text(view.environment_rotation) +
                   ", give a finite angle"};
}

std::vector<SpherePixel> sphere_pixels(const SphereView& view) {
    const CameraRays rays = camera_rays(view);
    std::vector<SpherePixel> pixels;
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (std::uint32_t x = 0; x < view.width; ++x) {
            const Vector direction =
                rays.direction(x + 0.5 - 0.5 * view.width, y + 0.5 - 0.5 * view.height);
            const Ray ray{direction, cross(rays.eye, direction)};
            const Margin distance = margin(rays, ray);
            if (may_be_covered(distance))
                pixels.push_back(sphere_pixel(rays, ray, distance, y * view.width + x));
        }
    return pixels;
}

bool sees_sphere(const SphereView& view) {
    const CameraRays rays = camera_rays(view);
    const Vector centre = -1.0 * rays.eye;
    if (dot(centre, rays.centre) < -1.0) return false; // behind the eye
    // The planes through the eye and a side of the picture; the inside is where the middle is.
    const Vector x = 0.5 * view.width * rays.per_x, y = 0.5 * view.height * rays.per_y;
    for (const auto& [side, along] :
         {std::pair{rays.centre + x, rays.per_y}, std::pair{rays.centre - x, rays.per_y},
          std::pair{rays.centre + y, rays.per_x}, std::pair{rays.centre - y, rays.per_x}}) {
        Vector inward = normalised(cross(side, along));
        if (dot(inward, rays.centre) < 0) inward = -1.0 * inward;
        if (dot(inward, centre) < -1.0) return false;
    }
    return true;
}

} // namespace lobelia::host
