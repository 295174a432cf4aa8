#pragma once

#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// A cube map bound to another that it is resampled into. Made by CubeToCube::bind; independent of
/// the object it came from, which may go first.
class LOBELIA_API CubeToCubeJob {
public:
    struct State;
    explicit CubeToCubeJob(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}

    /// Records the resampling into level 0 of the target. Never allocates, submits or waits.
    ///
    /// On entry the source is in SHADER_READ_ONLY_OPTIMAL, visible to compute shaders; the target's
    /// content (all levels) is discarded. On exit level 0 of the target holds the result and all
    /// its levels are in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders. Costs a
    /// fetch for each pair of texels that overlap.
    void record(VkCommandBuffer commands) const noexcept;

    /// Rows of texels of the target, on all its faces.
    std::uint32_t rows() const noexcept;
    /// The same in parts, as PanoramaToCubeJob::record().
    void record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// Area-true resampling of a cube map into another size, as Prefilter wants it: each texel becomes
/// the source's average over the texel's solid angle, NaN and negative radiance counting as 0 and
/// nothing for more than 2^120. The mean over the sphere stays the same to about 1e-6, and a
/// constant source stays that constant.
class LOBELIA_API CubeToCube {
public:
    /// Compiles the pipeline. Fails where Vulkan does.
    static Result<CubeToCube> create(const Device& device);

    /// Makes views and descriptors. `source` needs SAMPLED usage and any float format that can be
    /// sampled; `target` needs STORAGE and SAMPLED usage and format R32G32B32A32_SFLOAT. Faces have
    /// 1 to 16384 texels a side, those of the target at least a 200th of the source's. Both must
    /// outlive the job's last use on the device.
    Result<CubeToCubeJob> bind(const CubeMap& source, const CubeMap& target) const;

    struct State;

private:
    explicit CubeToCube(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
