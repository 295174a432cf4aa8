#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

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

/// How the sphere's colour is found.
enum class SphereMethod : std::uint32_t {
    split_sum, // kd P_1(N) + ks W(N.R, n) P_n(R), one fetch each
    reference, // the same sum with the integrals of Exact, one value per pixel
};

/// What is drawn: the unit sphere at the origin, seen by `camera` in an image of width x height.
struct SphereView {
    Camera camera;
    Material material;
    float environment_rotation = 0.0f; // radians about +Y, counter-clockwise seen from above
    bool background = true;            // the environment behind the sphere; else transparent black
    std::uint32_t width = 0;           // of the viewport, pixels
    std::uint32_t height = 0;
};

/// Where the sphere is drawn: a subpass of a render pass, or dynamic rendering into one attachment.
struct SphereTarget {
    VkRenderPass render_pass = VK_NULL_HANDLE; // null: dynamic rendering (the caller enabled it)
    std::uint32_t subpass = 0;
    VkFormat format = VK_FORMAT_UNDEFINED; // of colour attachment 0, linear
};

/// What the sphere pass reads. Null where the material or method has no use for it: `diffuse` where
/// kd = 0, `specular` where ks = 0, `background` where none is shown; `reference_*` are the result
/// buffers of Exact, entry y * width + x per pixel, for SphereMethod::reference alone.
struct SphereSources {
    VkImageView background = VK_NULL_HANDLE; // cube view
    VkImageView diffuse = VK_NULL_HANDLE;    // cube view of P_1
    VkImageView specular = VK_NULL_HANDLE;   // cube view of P_n
    VkBuffer reference_diffuse = VK_NULL_HANDLE;
    VkBuffer reference_specular = VK_NULL_HANDLE;
};

/// Maps bound for drawing. Made by Sphere::bind.
class SphereJob {
public:
    struct State;
    explicit SphereJob(std::unique_ptr<State> state) noexcept;
    SphereJob(SphereJob&&) noexcept;
    SphereJob& operator=(SphereJob&&) noexcept;
    ~SphereJob();

    /// Records the draw, to be called inside the caller's render pass or dynamic rendering. Sets
    /// viewport and scissor to view.width x view.height. The maps are in SHADER_READ_ONLY_OPTIMAL.
    /// Writes linear radiance, blended with the background by the fraction of the pixel that the
    /// sphere covers; that fraction is alpha. Never allocates, submits or waits.
    void record(VkCommandBuffer commands, const SphereView& view) const noexcept;

private:
    std::unique_ptr<State> state_;
};

/// The sphere, cast as a ray in every pixel: exact normals, no mesh, no vertex buffer.
class Sphere {
public:
    static Result<Sphere> create(const Device& device, const SphereTarget& target,
                                 SphereMethod method);
    Sphere(Sphere&&) noexcept;
    Sphere& operator=(Sphere&&) noexcept;
    ~Sphere();

    Result<SphereJob> bind(const SphereSources& sources) const;

private:
    struct State;
    explicit Sphere(std::shared_ptr<State> state) noexcept;
    std::shared_ptr<State> state_;
};

} // namespace lobelia
