#pragma once

#include <lobelia/host/work.h>
#include <lobelia/prefilter.h>

namespace lobelia::host {

/// Prefiltered maps with what belongs to them: their scale and suns in `state`.
struct PrefilteredMaps {
    std::vector<PrefilteredMap> descriptions;
    std::vector<GpuImage> images;
    GpuBuffer state;
    WorkReport report;
};

/// Runs the prefilter on the environment's cube map, pass by pass.
Outcome<PrefilteredMaps> make_maps(Gpu& gpu, const GpuEnvironment& environment,
                                   std::span<const float> exponents, bool lambert, Quality quality,
                                   const Progress& progress);

} // namespace lobelia::host
