#pragma once

#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// What the four texels below one count by.
enum class MipWeights {
    solid_angle, // the mean over the sphere is the same at every level
    equal,       // as vkCmdBlitImage does and Kurt 2019 did: the mean drifts
};

/// A cube map bound to the mips made of it. Made by Mips::bind; independent of the object it came
/// from, which may go first.
class LOBELIA_API MipsJob {
public:
    struct State;
    explicit MipsJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records the making of all levels, one dispatch each. On entry the source is in
    /// SHADER_READ_ONLY_OPTIMAL, visible to compute shaders; the target's content is discarded. On
    /// exit the target's levels are in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute
    /// shaders. Never allocates, submits or waits.
    void record(VkCommandBuffer commands) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// A cube map with mips, for Importance and for shaders that filter with them. Level 0 is the
/// source made sane: NaN and negative radiance become 0, and nothing stays above 2^120. Each
/// further texel is the average of the four below it, weighted as asked.
class LOBELIA_API Mips {
public:
    /// Compiles the pipelines. Fails where Vulkan does.
    static Result<Mips> create(const Device& device);

    /// Makes views and descriptors. Both are of the same size, a power of two; `target` has at most
    /// log2(size) + 1 levels, STORAGE and SAMPLED usage and one of two formats, which the caller
    /// weighs: R32G32B32A32_SFLOAT keeps every sun, but a device need not filter it
    /// (VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT tells), R16G16B16A16_SFLOAT is filtered
    /// everywhere, faster on most devices, and cuts radiance off at 65504. Both images must outlive
    /// the job's last use on the device.
    Result<MipsJob> bind(const CubeMap& source, const CubeMap& target,
                         MipWeights weights = MipWeights::solid_angle) const;

    struct State;

private:
    explicit Mips(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
