#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <lobelia/prefilter.h>

#include "kernel.h"

namespace lobelia {

/// A level of the chain in the scratch buffer: six faces of halves with margins.
struct ChainLevel {
    std::uint32_t size;
    std::uint32_t margin; // texels, even
    VkDeviceSize offset;  // bytes
    double exponent;      // of the lobe it has been blurred with; infinite: none
    double face_variance; // blur beyond that, in the face's plane, in its coordinates squared
    VkDeviceSize bytes() const;
};

// As in the shaders: degrees of the spherical harmonics, their terms and a term's bytes, and texels
// of a chunk of project.comp.
constexpr std::uint32_t DEGREES = 29;
constexpr double MEAN_READING = 0.6;
constexpr std::uint32_t TERMS = DEGREES * (DEGREES + 1) / 2;
constexpr std::uint32_t TERM_BYTES = 32;
constexpr std::uint32_t CHUNK_TEXELS = 16 * 8;

constexpr std::size_t PASS_KINDS = 11;

/// One pass of the plan: where it reads and writes, by index into levels or maps.
struct PlannedPass {
    enum class Kind {
        statistics,
        suns,
        prepare,
        suns_out,
        margins,
        halve,
        blur_level,
        blur_map,
        project,
        sum,
        expand
    } kind;
    std::uint32_t block = 1;  // source texels a side of one of `prepare` and `suns_out`
    std::uint32_t source = 0; // level; of `prepare` and `suns_out` the source image
    std::uint32_t target = 0; // level
    std::optional<std::uint32_t> map;
    Kernel kernel{};
    double narrowing = 0;            // face variance the kernel leaves out
    double drift = 0;                // and how far that draws towards the face's centre
    std::vector<double> eigenvalues; // of an expansion
};

struct PrefilterPlan::State {
    std::uint32_t source_size;
    Quality quality;
    float levels_up_to;
    VkFormat map_format;
    std::vector<PrefilteredMap> maps; // and after `map_count` the ladder's rungs
    std::size_t map_count;
    Ladder ladder;
    bool is_rung(std::uint32_t map) const { return map >= map_count; }
    /// Texels across a face of a map, less one where they reach its edges: see prefilter/map.glsl.
    std::uint32_t across(std::uint32_t map) const {
        return is_rung(map) ? maps[map].size - 1 : maps[map].size;
    }
    std::vector<ChainLevel> levels;
    std::vector<PlannedPass> passes; // those with a map last
    std::uint32_t source_passes;     // the first of all, which read the source
    std::uint32_t first_map_pass;
    VkDeviceSize tiles_bytes;
    VkDeviceSize terms_offset, terms_bytes; // partial sums of spherical harmonics
    VkDeviceSize scratch_bytes;
};

/// What sums over a level's texel middles take too much along the faces' edges, as a share of the
/// weight there times the squared distance of the face's plane: docs/prefilter.md.
double edge_excess(const ChainLevel& level);

constexpr std::uint32_t MOST_SUNS = 8; // as in lobelia/suns.glsl

/// Edge of the window of texels that holds a sun on a face of `size`: a sun's radius is 0.015
/// radians, three times as long in the face's plane at a corner. A multiple of the group's edge.
std::uint32_t sun_window(std::uint32_t size);

/// Fills in the maps, levels and passes for a request that is valid.
void plan_passes(const PrefilterRequest& request, PrefilterPlan::State& plan);

} // namespace lobelia
