#pragma once

#include <optional>
#include <string>
#include <vector>

#include <lobelia/host/read.h>

#include "measure_row.h"

namespace lobelia::cli {

/// An environment to measure on.
struct MeasureSource {
    std::string name;                      // of the file without folder and ending, or "built-in"
    std::optional<host::Environment> file; // absent: the built-in environment
    std::string fingerprint;               // the same for the same texels
    std::uint32_t face = 0;                // of its cube map at normal quality, texels

    bool is_panorama() const;
};

/// Which measurements are made.
struct MeasurePlan {
    bool prefilter = true;
    bool shade = true;
    bool quick = false; // fewer exponents, samples and face sizes; those there are, are the same
};

/// The measurements on all sources, in the order in which they are made: what is compared stands
/// together.
std::vector<MeasureCase> measure_cases(const std::vector<MeasureSource>& sources,
                                       const MeasurePlan& plan);

} // namespace lobelia::cli
