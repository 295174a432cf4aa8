#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/prefilter.h>
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

/// What the pass is compiled for. A part that is left out costs no fetch and no code.
struct SphereShading {
    SphereMethod method = SphereMethod::split_sum;
    bool diffuse = true;    // else kd counts as 0
    bool specular = true;   // else ks counts as 0
    bool background = true; // else nothing is drawn behind the sphere
    /// The maps come from Prefilter: they have a scale and suns beside them, in
    /// SphereSources::prefilter_state, and `specular_filter` says how the specular one is read.
    /// Else they hold the averages as they are, read bilinearly.
    bool prefiltered = false;
    MapFilter specular_filter = MapFilter::bilinear;
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

/// Where the sphere is drawn: a subpass of a render pass, or dynamic rendering into one attachment.
struct SphereTarget {
    VkRenderPass render_pass = VK_NULL_HANDLE; // null: dynamic rendering (the caller enabled it)
    std::uint32_t subpass = 0;
    VkFormat format = VK_FORMAT_UNDEFINED; // of colour attachment 0, linear
};

/// What the sphere pass reads; cube views in SHADER_READ_ONLY_OPTIMAL, of formats that can be
/// filtered. What SphereShading leaves out may be null, except `background`, which also stands in
/// for maps that are not there. SphereMethod::reference reads no maps but the result buffers of
/// Exact, entry y * width + x for pixel (x, y): `diffuse` has the averages of the lobe of exponent
/// 1 about the normal N, `specular` those of the exponent n about the mirror direction R, clipped
/// by the horizon of N. Both may be null for SphereMethod::split_sum.
struct SphereSources {
    VkImageView background = VK_NULL_HANDLE;   // the environment
    VkImageView diffuse = VK_NULL_HANDLE;      // P_1
    VkImageView specular = VK_NULL_HANDLE;     // P_n
    VkBuffer prefilter_state = VK_NULL_HANDLE; // with SphereShading::prefiltered
    VkBuffer reference_diffuse = VK_NULL_HANDLE;
    VkBuffer reference_specular = VK_NULL_HANDLE;
};

/// Maps bound for drawing. Made by Sphere::bind; independent of the object it came from, which may
/// go first.
class SphereJob {
public:
    struct State;
    explicit SphereJob(std::unique_ptr<State> state) noexcept;
    SphereJob(SphereJob&&) noexcept;
    SphereJob& operator=(SphereJob&&) noexcept;
    ~SphereJob();

    /// Records the draw, to be called inside the caller's render pass or dynamic rendering. Sets
    /// viewport and scissor to view.width x view.height. The eye is on the sphere or outside it.
    /// Writes linear radiance, blended with the background by the fraction of the pixel that the
    /// sphere covers; that fraction is alpha. Never allocates, submits or waits.
    void record(VkCommandBuffer commands, const SphereView& view) const noexcept;

private:
    std::unique_ptr<State> state_;
};

/// The sphere, cast as a ray in every pixel: exact normals, no mesh, no vertex buffer. Where the
/// silhouette cuts a pixel, the covered area is computed, not sampled, and a pixel whose centre
/// misses the sphere has the colour of the nearest point of the silhouette.
class Sphere {
public:
    /// Compiles the pipeline. Fails where Vulkan does.
    static Result<Sphere> create(const Device& device, const SphereTarget& target,
                                 const SphereShading& shading);
    Sphere(Sphere&&) noexcept;
    Sphere& operator=(Sphere&&) noexcept;
    ~Sphere();

    /// Makes descriptors. Refuses sources that lack what the shading reads. All handles must
    /// outlive the job's last use on the device.
    Result<SphereJob> bind(const SphereSources& sources) const;

    struct State;

private:
    explicit Sphere(std::shared_ptr<State> state) noexcept;
    std::shared_ptr<State> state_;
};

} // namespace lobelia
