#pragma once

#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// A panorama bound to the cube map it is resampled into. Made by PanoramaToCube::bind; independent
/// of the object it came from, which may go first.
class LOBELIA_API PanoramaToCubeJob {
public:
    struct State;
    explicit PanoramaToCubeJob(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}

    /// Records the resampling into level 0 of the target. Never allocates, submits or waits.
    ///
    /// On entry the panorama is in SHADER_READ_ONLY_OPTIMAL, visible to compute shaders; the
    /// target's content (all levels) is discarded. On exit level 0 of the target holds the result
    /// and all its levels are in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders.
    /// Costs a few operations for each pair of panorama texel and cube texel that overlap.
    void record(VkCommandBuffer commands) const noexcept;

    /// Rows of texels of the cube map, on all its faces.
    std::uint32_t rows() const noexcept;
    /// The same in parts, which may lie in several command buffers, submitted in order: rows
    /// [first, first + count), each row once and the first of all first. Between two parts the
    /// target is in GENERAL, and on exit from the last one as above. Bits do not depend on the
    /// parts.
    void record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// Area-true resampling: each cube texel becomes the panorama integrated over the texel's solid
/// angle, divided by it. No light appears or is lost, however small its source: the two maps' means
/// over the sphere agree to about 1e-5, and a constant panorama stays that constant.
class LOBELIA_API PanoramaToCube {
public:
    /// Compiles the pipeline. Fails where Vulkan does.
    static Result<PanoramaToCube> create(const Device& device);

    /// Makes views and descriptors. `source` needs SAMPLED usage and sides of 1 to 32768 texels;
    /// `target` needs STORAGE and SAMPLED usage and format R32G32B32A32_SFLOAT. Both must outlive
    /// the job's last use on the device.
    Result<PanoramaToCubeJob> bind(const Panorama& source, const CubeMap& target) const;

    struct State;

private:
    explicit PanoramaToCube(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
