#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/result.h>
#include <lobelia/sphere_method.h>

namespace lobelia {

/// The normalised Phong material of Kurt 2019, "Real-Time Shading with Phong BRDF Model", eq. 4.
/// Linear RGB. Physical where 0 <= diffuse, 0 <= specular and diffuse + specular <= 1 per channel.
struct Material {
    std::array<float, 3> diffuse{};  // kd
    std::array<float, 3> specular{}; // ks
    float exponent = 1.0f;           // n, in [0, 1e6]
};

/// A pinhole camera. Right-handed world, +Y up.
struct Camera {
    std::array<float, 3> eye{0, 0, 4};
    std::array<float, 3> target{0, 0, 0};
    std::array<float, 3> up{0, 1, 0};
    float vertical_field_of_view = 30.0f; // degrees, in (0, 180)
};

/// What is drawn: the unit sphere at the origin, seen by `camera` in an image of width x height.
struct SphereView {
    Camera camera;
    Material material;
    /// Radians about +Y. A positive angle turns the environment counter-clockwise as seen from
    /// above: light from direction d is found at d turned by the negative angle, so that what stood
    /// in +Z stands in +X after a quarter turn.
    float environment_rotation = 0.0f;
    bool background = true;  // the environment behind the sphere; else transparent black
    std::uint32_t width = 0; // of the viewport, pixels
    std::uint32_t height = 0;
};

/// Pixels of the picture among which are all that the sphere covers, at least partly. Empty where
/// there are none.
LOBELIA_API VkRect2D sphere_bounds(const SphereView& view) noexcept;

/// Where the sphere is drawn: a subpass of a render pass, or dynamic rendering into one attachment.
struct SphereTarget {
    VkRenderPass render_pass = VK_NULL_HANDLE; // null: dynamic rendering (the caller enabled it)
    std::uint32_t subpass = 0;
    VkFormat format = VK_FORMAT_UNDEFINED; // of colour attachment 0, linear
};

/// Maps bound for drawing. Made by Sphere::bind; independent of the object it came from, which may
/// go first.
class LOBELIA_API SphereJob {
public:
    struct State;
    explicit SphereJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records the draw, to be called inside the caller's render pass or dynamic rendering. Sets
    /// viewport and scissor to view.width x view.height. The eye is on the sphere or outside it.
    /// Writes linear radiance, blended with the background by the fraction of the pixel that the
    /// sphere covers; that fraction is alpha. Never allocates, submits or waits.
    void record(VkCommandBuffer commands, const SphereView& view) const noexcept;
    /// The same of the pixels in `part` alone, which lies in the viewport: for a picture of which
    /// the rest is there. Edits of the material change none outside sphere_bounds().
    void record(VkCommandBuffer commands, const SphereView& view,
                const VkRect2D& part) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// The sphere, cast as a ray in every pixel: exact normals, no mesh, no vertex buffer. Where the
/// silhouette cuts a pixel, the covered area is computed, not sampled, and a pixel whose centre
/// misses the sphere has the colour of the nearest point of the silhouette.
class LOBELIA_API Sphere {
public:
    /// Compiles the pipeline. Fails where Vulkan does.
    static Result<Sphere> create(const Device& device, const SphereTarget& target,
                                 const SphereShading& shading);

    /// Makes descriptors. Refuses sources that lack what the shading reads. All handles must
    /// outlive the job's last use on the device.
    Result<SphereJob> bind(const SphereSources& sources) const;

    struct State;

private:
    explicit Sphere(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
