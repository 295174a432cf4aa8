#pragma once

#include <lobelia/importance.h>

#include "host/averages.h"
#include "host/directions.h"

namespace lobelia::host {

/// Averages `source` about the unit vectors `axes` with Importance, one submission a step, so that
/// none is long. The number of queries in `settings` is not read.
Outcome<Averages> average_by_samples(Gpu& gpu, const Importance& importance, const GpuImage& source,
                                     ImportanceSettings settings, std::span<const Vector> axes,
                                     const Progress& progress);

/// What a report says of `count` averages over mips of that many bytes.
PassReport importance_pass(bool filtered, std::uint64_t mips_bytes, std::uint64_t count);

} // namespace lobelia::host
