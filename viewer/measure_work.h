#pragma once

#include <map>
#include <span>

#include "measure_folder.h"

namespace lobelia::cli {

/// What all measurements have in common, for the report.
nlohmann::ordered_json measure_settings();

/// Makes measurements, those that are compared in one.
class Measurer {
public:
    Measurer(host::Gpu& gpu, const MeasureFolder& folder) : gpu_(gpu), folder_(folder) {}

    /// All of one task, on `source` and at one exponent.
    host::Outcome<std::vector<MeasureRow>> measure(std::span<const MeasureCase> cases,
                                                   const MeasureSource& source);

private:
    host::Gpu& gpu_;
    const MeasureFolder& folder_;

    std::string environment_;                               // the one at hand
    std::map<std::uint32_t, host::GpuEnvironment> uploads_; // its, by face size

    host::Outcome<const host::GpuEnvironment*> upload(const MeasureSource& source,
                                                      std::uint32_t face);
    host::Outcome<host::Measured> exact_prefilter(float exponent, const MeasureSource& source);
    host::Outcome<host::Measured> reference(float exponent, const MeasureSource& source);
    host::Outcome<std::vector<host::Measured>> prefilter(std::span<const MeasureCase> cases,
                                                         const MeasureSource& source);
    host::Outcome<std::vector<host::Measured>> shade(std::span<const MeasureCase> cases,
                                                     const MeasureSource& source);
};

} // namespace lobelia::cli
