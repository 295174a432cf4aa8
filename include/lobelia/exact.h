#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// One direction at which the environment is asked for, as it lies in the query buffer.
/// `axis` is a unit vector; `normal` a unit vector, read only where the lobe is clipped by a
/// horizon.
struct ExactQuery {
    float axis[3];
    float unused0;
    float normal[3];
    float unused1;
};

/// What is averaged, and with which weight.
struct ExactSettings {
    float exponent = 1.0f; // n in [0, 1e6]
    /// false: weight max(0, w.axis)^n; the average is P_n(axis).
    /// true: weight max(0, w.axis)^n max(0, w.normal), the specular lobe with its horizon.
    bool clipped = false;
    std::uint32_t query_count = 0;
    /// Nodes of integration that one dispatch may visit: sizes a step. 2^25 is about 0.1 s on two
    /// CPU cores, a millisecond on a GPU.
    std::uint64_t nodes_per_step = std::uint64_t(1) << 25;
};

/// A list of directions bound to an environment. Made by Exact::bind.
class LOBELIA_API ExactJob {
public:
    struct State;
    explicit ExactJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// How many steps the work is split into; one step is at most one dispatch of bounded size.
    std::uint32_t steps() const noexcept;

    /// Records steps [first, first + count), which must be recorded in order and once each; they
    /// may be spread over any number of command buffers submitted in order. Split or not, the bits
    /// are the same. Never allocates, submits or waits.
    ///
    /// On entry the environment is in SHADER_READ_ONLY_OPTIMAL and the queries are visible to
    /// compute shaders. After the last step entry `i` of the result buffer is the average for query
    /// `i` (R, G, B) and the integral of the weight over the sphere of directions as summed (A),
    /// visible to fragment and compute shaders and to the host.
    void record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// The truth that every other method is measured against: weighted averages over every texel of an
/// environment, each texel constant over its own exact solid angle, the weight integrated over the
/// texel's area, and the sum divided by the sum of the weights. Cost: the number of queries times
/// the number of texels in the lobe's support.
class LOBELIA_API Exact {
public:
    static Result<Exact> create(const Device& device);

    /// Buffers that bind() needs, in bytes. `queries`: ExactQuery each, STORAGE_BUFFER. `results`:
    /// four floats each, STORAGE_BUFFER. `tables`: STORAGE_BUFFER and TRANSFER_DST, filled by step
    /// 0.
    struct Sizes {
        VkDeviceSize queries, results, tables;
    };
    static Result<Sizes> sizes(const Panorama& source, const ExactSettings& settings) noexcept;
    static Result<Sizes> sizes(const CubeMap& source, const ExactSettings& settings) noexcept;

    /// Makes views and descriptors. The source needs SAMPLED usage. Both functions refuse exponents
    /// outside [0, 1e6] and empty lists. All handles must outlive the job's last use on the device.
    Result<ExactJob> bind(const Panorama& source, const ExactSettings& settings, VkBuffer queries,
                          VkBuffer results, VkBuffer tables) const;
    Result<ExactJob> bind(const CubeMap& source, const ExactSettings& settings, VkBuffer queries,
                          VkBuffer results, VkBuffer tables) const;

    struct State;

private:
    explicit Exact(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
