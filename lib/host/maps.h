#pragma once

#include <memory>

#include <lobelia/clipped_tables.h>
#include <lobelia/host/work.h>
#include <lobelia/map_reader.h>
#include <lobelia/prefilter.h>

#include "host/averages.h"
#include "host/directions.h"

namespace lobelia::host {

/// The edge of a cube map that prefilters read in place of one of `face` texels.
std::uint32_t prefilter_face(std::uint32_t face);

/// Prefiltered maps with what belongs to them: their scale and suns in `state`.
struct PrefilteredMaps {
    std::vector<PrefilteredMap> descriptions;
    std::vector<GpuImage> images;
    std::optional<GpuImage> ladder;
    GpuBuffer state;
    WorkReport report;
};
/// Suns that were taken out of the maps, once they are made.
std::uint32_t sun_count(const PrefilteredMaps& maps);

/// Maps that are ready to be made, any number of times, by recording all passes of `plan`.
struct MapsJob {
    PrefilterPlan plan;
    std::shared_ptr<const GpuBuffer> scratch;
    PrefilterJob job;
    PrefilteredMaps maps;
};
/// The request's source size is that of the environment's source().
Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, PrefilterRequest request);
/// The plan is for the environment's source().
Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, const PrefilterPlan& plan);
/// From a source of the plan's size. With `levels_of`, a job of the same source whose plan shares
/// levels and whose passes have made them, the passes from first_map_pass() on are enough.
Outcome<MapsJob> bind_maps(Gpu& gpu, const Prefilter& prefilter, const GpuImage& source,
                           const PrefilterPlan& plan, const MapsJob* levels_of = nullptr);

/// Runs the prefilter on the environment's cube map, pass by pass.
Outcome<PrefilteredMaps> make_maps(Gpu& gpu, const GpuEnvironment& environment,
                                   const PrefilterPlan& plan, const Progress& progress);

/// The error to expect of maps that are asked for so, from faces of `source_size` texels: the
/// largest among theirs.
double expected_error(const PrefilterSettings& settings, std::uint32_t source_size);

/// What a report says of the plan's maps.
std::vector<ImageReport> map_reports(const PrefilterPlan& plan);

/// The tables of ClippedTables, on their way to the device: one image for every environment and
/// material.
struct ClippedTablesUpload {
    ClippedTables tables;
    GpuImage image;
    GpuBuffer buffer;

    static Outcome<ClippedTablesUpload> create(Gpu& gpu);
    void record(VkCommandBuffer commands) const {
        tables.record(commands, buffer.handle(), image.handle());
    }
};
/// The image alone. Adds the times of the upload to `run`.
Outcome<GpuImage> make_clipped_tables(Gpu& gpu, PassReport& run);

/// What a report says of reading a map of that many bytes at `count` directions.
PassReport read_map_pass(std::uint64_t map_bytes, std::uint64_t count);

/// Reads map `index` of `maps` at the unit vectors `axes`.
Outcome<Averages> read_map(Gpu& gpu, const MapReader& reader, const PrefilteredMaps& maps,
                           std::size_t index, std::span<const Vector> axes);

} // namespace lobelia::host
