#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/prefilter.h>
#include <lobelia/result.h>

namespace lobelia {

/// A prefiltered map with a list of directions. Made by MapReader::bind.
class LOBELIA_API MapReaderJob {
public:
    struct State;
    explicit MapReaderJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records the reading. On entry the map is in SHADER_READ_ONLY_OPTIMAL and the directions and
    /// the state buffer are visible to compute shaders; on exit the results are visible to compute
    /// and fragment shaders and to the host. Never allocates, submits or waits.
    void record(VkCommandBuffer commands) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// Reads P_n from a prefiltered map at given directions, with its scale undone and its suns put
/// back, by the functions of lobelia/prefiltered.glsl: for files that other programs read, and to
/// measure.
class LOBELIA_API MapReader {
public:
    static Result<MapReader> create(const Device& device);

    /// What is read: entry `i` of `directions` and of `results` are four floats, a unit vector (and
    /// nothing) and R G B 1. All buffers have STORAGE_BUFFER usage; `view` is a cube view of the
    /// map.
    struct Request {
        PrefilteredMap map;
        VkImageView view = VK_NULL_HANDLE;
        VkBuffer state = VK_NULL_HANDLE; // of the prefilter that made the map
        VkBuffer directions = VK_NULL_HANDLE;
        VkBuffer results = VK_NULL_HANDLE;
        std::uint32_t count = 0; // at least 1
    };
    /// All handles must outlive the job's last use on the device.
    Result<MapReaderJob> bind(const Request& request) const;

    struct State;

private:
    explicit MapReader(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
