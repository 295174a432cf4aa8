#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <lobelia/device.h>
#include <lobelia/image.h>
#include <lobelia/pass_rate.h>
#include <lobelia/result.h>

namespace lobelia {

/// How exact the maps are and what they cost. docs/prefilter.md has the figures and the command
/// that measures them.
enum class Quality : std::uint32_t {
    // Pointwise relative RMS on photographed panoramas for n up to 700, and at 2048:
    fast,   // 4e-3 and 7e-3: coarser maps and narrower kernels
    normal, // 2e-3 and 4e-3
    high,   // 1e-3 and 1e-3: finer maps and wider kernels, of a source of twice the size
};

/// How a map is meant to be read: the blur of that filter is left out of the map.
enum class MapFilter : std::uint32_t { bilinear, spline };

/// One map to make: a cube image of one level in the request's format, STORAGE and SAMPLED usage.
struct PrefilteredMap {
    float exponent = 1.0f;
    std::uint32_t size = 0; // edge of a face, texels
    MapFilter filter = MapFilter::bilinear;
};

/// Maps for exponents that vary from pixel to pixel, or with the angle to the horizon: a ladder of
/// `rungs` exponents from `lowest` on, each sqrt(2) times the one before (lobelia/ladder.glsl,
/// which also reads them). Stored as one 2D array of 6 layers a rung, faces in Vulkan's order,
/// whose texels reach the faces' edges, read bilinearly.
struct Ladder {
    float lowest = 1.0f;     // >= 1
    std::uint32_t rungs = 0; // 0: no ladder; else at least 2
};
LOBELIA_API float exponent_at(const Ladder& ladder, std::uint32_t rung) noexcept;

struct PrefilterRequest {
    std::span<const float> exponents; // each in [0, 1e6]: a map of P_n at exactly that exponent
    bool lambert = false;             // one map more: P_1 for the diffuse lobe, read bilinearly
    Ladder ladder;
    Quality quality = Quality::normal;
    /// For exponents that will be edited: the sharpest to come. All levels that maps up to it can
    /// be blurred from are made, and stay in the scratch buffer for the maps of later plans
    /// (PrefilterPlan::shares_levels). 0: the levels that these maps need, and no longer.
    float levels_up_to = 0;
    /// Of maps and ladder. Halves lose no sun: suns lie beside the maps and a power of two scales
    /// them.
    VkFormat map_format = VK_FORMAT_R16G16B16A16_SFLOAT; // or R32G32B32A32_SFLOAT
    /// Edge of the source's faces, a power of two from 16 to 1024; CubeToCube makes one of another.
    std::uint32_t source_size = 0;
};

/// What one pass costs. Bytes count each texel once (its footprint), those of the source as
/// R32G32B32A32_SFLOAT.
struct PrefilterPass {
    const char* name = "";
    std::uint64_t invocations = 0;
    std::uint64_t bytes_read = 0;
    std::uint64_t bytes_written = 0;
    double work = 0; // what its time is in proportion to, among passes of its name
};

/// The passes and memory that a list of maps needs. Depends on the request alone, so it can be made
/// before there is a device.
class LOBELIA_API PrefilterPlan {
public:
    struct State;
    static Result<PrefilterPlan> make(const PrefilterRequest& request);
    explicit PrefilterPlan(std::shared_ptr<const State> state) noexcept;

    /// What to create: one entry per exponent in the order of the request, then Lambert.
    std::span<const PrefilteredMap> maps() const noexcept;

    /// What the ladder's image is: ladder_size() texels a side, 6 layers a rung, one level, STORAGE
    /// and SAMPLED usage.
    Ladder ladder() const noexcept;
    std::uint32_t ladder_size() const noexcept;

    /// Edge of the faces of the source, and of the finest level made of it: a source of that size
    /// would do. Texels.
    std::uint32_t source_size() const noexcept;
    std::uint32_t finest_level() const noexcept;

    /// Bytes of the scratch buffer: STORAGE_BUFFER, UNIFORM_TEXEL_BUFFER usage. Free again when the
    /// recorded commands have run, unless its levels are to be kept. Plans that share levels have
    /// the same size.
    VkDeviceSize scratch_size() const noexcept;

    /// Bytes of the state buffer, STORAGE_BUFFER and UNIFORM_BUFFER usage: the maps' scale and suns
    /// (PrefilterState of lobelia/suns.glsl), to be kept as long as the maps and read as uniforms.
    /// A ladder from levels that are kept needs TRANSFER_DST usage too.
    VkDeviceSize state_size() const noexcept;

    /// Number of passes; PrefilterJob::record() takes any range of them.
    std::uint32_t pass_count() const noexcept;
    /// Passes from this one on make the maps and the ladder, those before it the levels that they
    /// are blurred from.
    std::uint32_t first_map_pass() const noexcept;
    /// Passes before this one read the source, the others do not.
    std::uint32_t source_pass_count() const noexcept;
    /// Whether the levels that `other`'s passes left in a scratch buffer are those of this plan:
    /// both were made with the same source size, quality and levels_up_to, which is not 0. A job of
    /// this plan, bound to the same source, scratch and state buffer, then makes its maps by the
    /// passes from first_map_pass() on, with the same bits as by all of them.
    bool shares_levels(const PrefilterPlan& other) const noexcept;
    PrefilterPass pass(std::uint32_t index) const noexcept;

    const State& state() const noexcept { return *state_; }

private:
    std::shared_ptr<const State> state_;
};

/// Queries of the caller's pool of timestamps, reset, for PrefilterJob::record(): pass `i` writes
/// query `first` + 2 `i` before it begins and the next one when it has ended.
struct PassTimestamps {
    VkQueryPool pool = VK_NULL_HANDLE; // null: none
    std::uint32_t first = 0;           // pool's size >= first + 2 * plan.pass_count()
};

/// Where a recording that is spread over frames goes on: a piece of a pass, which is a row of its
/// workgroups.
struct PrefilterPosition {
    std::uint32_t pass = 0;
    std::uint32_t piece = 0;

    bool operator==(const PrefilterPosition&) const = default;
};

/// A source, maps and buffers bound for recording. Made by Prefilter::bind.
class LOBELIA_API PrefilterJob {
public:
    struct State;
    explicit PrefilterJob(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}

    /// Records passes [first, first + count) of the plan, in order and once each; they may be
    /// spread over command buffers submitted in order, with the same bits. Begin at pass 0, or at
    /// the plan's first_map_pass() where the levels are there from a plan that shares them. Never
    /// allocates, submits or waits.
    ///
    /// On entry the maps' and the ladder's content is discarded; from pass 0 on also the state
    /// buffer's, and the source is in SHADER_READ_ONLY_OPTIMAL, visible to compute shaders. After
    /// the last pass maps and ladder are in SHADER_READ_ONLY_OPTIMAL and with the state buffer
    /// visible to fragment and compute shaders.
    void record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                const PassTimestamps& timestamps = {}) const noexcept;

    /// The same in pieces, for an environment that lives: records on from `from` what is predicted
    /// to take `milliseconds` by `rates`, at least one piece, and returns where the next call goes
    /// on; at the plan's pass_count() the maps are whole. Their bits do not depend on the pieces.
    /// The source stays as it is until the plan's source_pass_count() passes have run. Shade from
    /// the maps and the state buffer of another job meanwhile; scratch may be shared.
    PrefilterPosition record(VkCommandBuffer commands, PrefilterPosition from, double milliseconds,
                             std::span<const PassRate> rates) const noexcept;
    /// How many such calls make the maps: the frames that they are behind the environment.
    std::uint32_t frames(double milliseconds, std::span<const PassRate> rates) const noexcept;

private:
    std::shared_ptr<const State> state_;
};

/// Blurs a cube map with Phong lobes: suns taken out, a chain of positive zonal kernels matched to
/// the lobes' spectrum, direct sums for low exponents.
class LOBELIA_API Prefilter {
public:
    static Result<Prefilter> create(const Device& device);

    /// Makes views and descriptors. `maps` are what plan.maps() says, in its order, and `ladder`
    /// the image that holds plan.ladder(), null where it has no rungs. All handles must outlive the
    /// job's last use on the device.
    Result<PrefilterJob> bind(const PrefilterPlan& plan, const CubeMap& source,
                              std::span<const CubeMap> maps, VkBuffer scratch, VkBuffer state,
                              VkImage ladder = VK_NULL_HANDLE) const;

    struct State;

private:
    explicit Prefilter(std::shared_ptr<const State> state) noexcept : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

} // namespace lobelia
