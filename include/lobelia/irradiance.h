#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// A cube map bound to the coefficients made of it. Made by Irradiance::bind; independent of the
/// object it came from, which may go first.
class LOBELIA_API IrradianceJob {
public:
    struct State;
    explicit IrradianceJob(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}

    /// Records three dispatches. On entry the source is in SHADER_READ_ONLY_OPTIMAL, visible to
    /// compute shaders; the buffers' content is discarded. On exit the coefficients are visible to
    /// fragment and compute shaders and to the host. The same light gives the same bits every time.
    /// Never allocates, submits or waits.
    void record(VkCommandBuffer commands) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// The diffuse lobe's light as spherical harmonics, the field's usual way (Ramamoorthi and Hanrahan
/// 2001, "An Efficient Representation for Irradiance Environment Maps"), to compare with. Texels
/// count by their solid angle, suns among them; what is no radiance is made sane as in Mips. A
/// shader evaluates the coefficients with lobelia/irradiance.glsl. docs/shading.md has the errors.
class LOBELIA_API Irradiance {
public:
    /// Bytes of the coefficients: 18 times R G B 0 as floats, std140 for a uniform buffer.
    static constexpr VkDeviceSize COEFFICIENTS_SIZE = 18 * 16;
    /// Bytes of the scratch buffer for a source of that size, which the recorded commands use; 0
    /// where bind() refuses the size.
    static VkDeviceSize scratch_size(const CubeMap& source) noexcept;

    /// Compiles the pipelines. Fails where Vulkan does.
    static Result<Irradiance> create(const Device& device);

    /// Makes views and descriptors. `source` is of any size from 1 to 16384 texels; both buffers
    /// have STORAGE_BUFFER usage and the sizes above. All handles must outlive the job's last use
    /// on the device.
    Result<IrradianceJob> bind(const CubeMap& source, VkBuffer scratch,
                               VkBuffer coefficients) const;

    struct State;

private:
    explicit Irradiance(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
