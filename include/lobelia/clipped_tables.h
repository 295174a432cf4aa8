#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/prefilter.h>
#include <lobelia/result.h>

namespace lobelia {

/// How many lobes of lobelia/taps.glsl stand for the specular lobe that the horizon cuts.
enum class Taps : std::uint32_t { one = 1, two = 2, five = 5 };

/// The ladder that those lobes are read from for materials of exponents from `least` to `most`,
/// each in [0, 1e6] and `least` <= `most`. Takes about 5 milliseconds.
LOBELIA_API Ladder ladder_for(Taps taps, float least, float most);

/// The tables that lobelia/taps.glsl reads: where lobes that the horizon cuts are best read. They
/// hold for every material and environment; one image serves all.
class LOBELIA_API ClippedTables {
public:
    /// The image: 2D array of one level, SAMPLED and TRANSFER_DST usage.
    static constexpr std::uint32_t WIDTH = 32, HEIGHT = 16, LAYERS = 2;
    static constexpr VkFormat FORMAT = VK_FORMAT_R16G16B16A16_SFLOAT;
    /// Bytes of a buffer to go through, TRANSFER_SRC and TRANSFER_DST usage.
    static constexpr VkDeviceSize BUFFER_BYTES = WIDTH * HEIGHT * LAYERS * 8;

    /// Computes the tables in double precision: about 50 milliseconds. Fails without memory.
    static Result<ClippedTables> create(const Device& device);

    /// Records the upload, outside of render passes. The image's content is discarded; afterwards
    /// it is in SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders. The buffer is
    /// free again when the commands have run. Never allocates, submits or waits.
    void record(VkCommandBuffer commands, VkBuffer buffer, VkImage image) const noexcept;

    struct State;

private:
    explicit ClippedTables(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
