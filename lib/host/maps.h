#pragma once

#include <lobelia/host/work.h>
#include <lobelia/prefilter.h>

namespace lobelia::host {

/// The environment's cube map in a size that prefilters read, a power of two from 16 to 1024;
/// nothing where it has one already.
Outcome<std::optional<GpuImage>> resized_cube(Gpu& gpu, const GpuEnvironment& environment);

/// Prefiltered maps with what belongs to them: their scale and suns in `state`.
struct PrefilteredMaps {
    std::vector<PrefilteredMap> descriptions;
    std::vector<GpuImage> images;
    std::optional<GpuImage> ladder;
    GpuBuffer state;
    WorkReport report;
};

/// Runs the prefilter on the environment's cube map, pass by pass. The request's source size is
/// that of the environment.
Outcome<PrefilteredMaps> make_maps(Gpu& gpu, const GpuEnvironment& environment,
                                   PrefilterRequest request, const Progress& progress);

/// The tables of ClippedTables, on the device: one image for every environment and material.
Outcome<GpuImage> make_clipped_tables(Gpu& gpu);

} // namespace lobelia::host
