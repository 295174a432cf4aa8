#pragma once

#include <lobelia/importance.h>

#include "host/averages.h"
#include "host/directions.h"

namespace lobelia::host {

/// The environment's cube map with mips, in SHADER_READ_ONLY_OPTIMAL: in 32 bits where the device
/// filters them, else in 16.
struct EnvironmentMips {
    GpuImage image;
    WorkReport report;
};
/// All levels for filtered sampling, else level 0 alone.
Outcome<EnvironmentMips> make_mips(Gpu& gpu, const GpuEnvironment& environment, bool filtered);

/// Averages `source` about the unit vectors `axes` with Importance, one submission a step, so that
/// none is long. The number of queries in `settings` is not read.
Outcome<Averages> average_by_samples(Gpu& gpu, const Importance& importance, const GpuImage& source,
                                     ImportanceSettings settings, std::span<const Vector> axes,
                                     const Progress& progress);

} // namespace lobelia::host
