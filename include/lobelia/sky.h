#pragma once

#include <memory>

#include <lobelia/device.h>
#include <lobelia/result.h>

#include <vulkan/vulkan_core.h>

namespace lobelia {

/// Where the sky is drawn: a 2D image of one layer, lent, with STORAGE usage and format
/// R32G32B32A32_SFLOAT, and a view of its level 0.
struct SkyTarget {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    std::uint32_t width = 0;  // texels, at least 2
    std::uint32_t height = 0; // at least 1
};

/// A panorama bound to be filled. Made by Sky::bind; independent of the object it came from.
class LOBELIA_API SkyJob {
public:
    struct State;
    explicit SkyJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records the drawing. The target's content is discarded; on exit it holds the sky in linear
    /// radiance, alpha 1, in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders.
    /// Never allocates, submits or waits.
    void record(VkCommandBuffer commands) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// An environment that needs no file: a clear evening sky over a tiled floor, a warm and a cool
/// soft box, a lamp, and a small sun some 10^4 times as bright as the rest. No two sides look
/// alike, so a mirrored or turned picture shows. The sun's power is the same at every resolution.
class LOBELIA_API Sky {
public:
    /// Compiles the pipeline. Fails where Vulkan does.
    static Result<Sky> create(const Device& device);

    /// Makes descriptors. All handles must outlive the job's last use on the device.
    Result<SkyJob> bind(const SkyTarget& target) const;

    struct State;

private:
    explicit Sky(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
