#pragma once

#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/prefilter.h>
#include <lobelia/result.h>

namespace lobelia {

/// A prefiltered map with the cube map that shows it. Made by PlainMap::bind; independent of the
/// object it came from, which may go first.
class LOBELIA_API PlainMapJob {
public:
    struct State;
    explicit PlainMapJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records one dispatch. On entry the map is in SHADER_READ_ONLY_OPTIMAL and it and the state
    /// buffer are visible to compute shaders; the target's content is discarded. On exit the target
    /// is in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders. Costs four fetches
    /// and the suns a texel. Never allocates, submits or waits.
    void record(VkCommandBuffer commands) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// P_n as a cube map for any reader, which knows neither the map's scale nor its suns nor its
/// filter: what prefiltered_spline or prefiltered_bilinear of lobelia/prefiltered.glsl give at the
/// middle of each texel. For a blurred background, and for shaders that are not ours.
class LOBELIA_API PlainMap {
public:
    /// Compiles the pipelines. Fails where Vulkan does.
    static Result<PlainMap> create(const Device& device);

    /// `view` is a cube view of the map, `state` the state buffer of the prefilter that makes it,
    /// with UNIFORM_BUFFER usage. `target` has STORAGE usage, format R32G32B32A32_SFLOAT and one
    /// level.
    struct Request {
        PrefilteredMap map;
        VkImageView view = VK_NULL_HANDLE;
        VkBuffer state = VK_NULL_HANDLE;
        CubeMap target;
    };
    /// Makes a view and descriptors. All handles must outlive the job's last use on the device.
    Result<PlainMapJob> bind(const Request& request) const;

    struct State;

private:
    explicit PlainMap(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
