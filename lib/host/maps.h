#pragma once

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

/// Maps that are ready to be made, any number of times, by recording all passes of `plan`.
struct MapsJob {
    PrefilterPlan plan;
    std::optional<GpuImage> resized; // the source, where the environment's cube is none
    GpuBuffer scratch;
    PrefilterJob job;
    PrefilteredMaps maps;
};
/// The request's source size is that of the environment.
Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, PrefilterRequest request);
/// The plan's source size is prefilter_face() of the environment's.
Outcome<MapsJob> bind_maps(Gpu& gpu, const GpuEnvironment& environment, const PrefilterPlan& plan);

/// Runs the prefilter on the environment's cube map, pass by pass.
Outcome<PrefilteredMaps> make_maps(Gpu& gpu, const GpuEnvironment& environment,
                                   const PrefilterPlan& plan, const Progress& progress);

/// What a report says of the plan's maps.
std::vector<ImageReport> map_reports(const PrefilterPlan& plan);

/// The tables of ClippedTables, on the device: one image for every environment and material. Adds
/// the times of the upload to `run`.
Outcome<GpuImage> make_clipped_tables(Gpu& gpu, PassReport& run);

/// What a report says of reading a map of that many bytes at `count` directions.
PassReport read_map_pass(std::uint64_t map_bytes, std::uint64_t count);

/// Reads map `index` of `maps` at the unit vectors `axes`.
Outcome<Averages> read_map(Gpu& gpu, const MapReader& reader, const PrefilteredMaps& maps,
                           std::size_t index, std::span<const Vector> axes);

} // namespace lobelia::host
