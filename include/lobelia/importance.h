#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/result.h>

namespace lobelia {

/// What is averaged, and by how many samples.
struct ImportanceSettings {
    float exponent = 1.0f;      // n in [0, 1e6]: the average is P_n
    std::uint32_t samples = 64; // of each direction, 1 to 65535
    /// true: each sample is one trilinear fetch at the level whose texels cover the sample's share
    /// of the sphere; the source has all its levels, as Mips makes them.
    /// false: each sample is one bilinear fetch of level 0.
    bool filtered = true;
    std::uint32_t query_count = 0;
    /// Samples that one dispatch may take: sizes a step. 2^20 is below 0.1 s on two CPU cores; a
    /// GPU is kept busier by more.
    std::uint64_t samples_per_step = std::uint64_t(1) << 20;
};

/// A list of directions bound to an environment. Made by Importance::bind.
class LOBELIA_API ImportanceJob {
public:
    struct State;
    explicit ImportanceJob(std::shared_ptr<const State> state) noexcept
        : state_(std::move(state)) {}

    /// How many steps the work is split into; one step is one dispatch of bounded size.
    std::uint32_t steps() const noexcept;

    /// Records steps [first, first + count), which must be recorded in order and once each; they
    /// may be spread over any number of command buffers submitted in order. Split or not, the bits
    /// are the same. Never allocates, submits or waits.
    ///
    /// On entry the source is in SHADER_READ_ONLY_OPTIMAL and with the directions visible to
    /// compute shaders. After the last step the results are visible to compute and fragment shaders
    /// and to the host.
    void record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// The usual ways to prefilter, to compare with: importance sampling, and filtered importance
/// sampling (Krivanek and Colbert 2008, "Real-time Shading with Filtered Importance Sampling"). N
/// directions are drawn from the lobe itself by the Hammersley set, the same for every axis, so the
/// average is the mean of what is fetched there (lobelia/importance.glsl, which an engine's shader
/// can include). docs/prefilter.md has the errors. Cost: N fetches for each direction.
class LOBELIA_API Importance {
public:
    /// Compiles the pipelines. Fails where Vulkan does.
    static Result<Importance> create(const Device& device);

    /// Makes views and descriptors. `source` has SAMPLED usage and a format that the device filters
    /// linearly. Entry `i` of `directions` and of `results` are four floats, a unit vector (and
    /// nothing) and R G B 1; both buffers have STORAGE_BUFFER usage. All handles must outlive the
    /// job's last use on the device.
    Result<ImportanceJob> bind(const CubeMap& source, const ImportanceSettings& settings,
                               VkBuffer directions, VkBuffer results) const;

    struct State;

private:
    explicit Importance(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
