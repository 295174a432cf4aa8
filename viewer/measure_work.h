#pragma once

#include <map>

#include "measure_folder.h"

namespace lobelia::cli {

/// What all measurements have in common, for the report.
nlohmann::ordered_json measure_settings();

/// Makes measurements, one after another.
class Measurer {
public:
    Measurer(host::Gpu& gpu, const MeasureFolder& folder) : gpu_(gpu), folder_(folder) {}

    host::Outcome<MeasureRow> measure(const MeasureCase& what, const MeasureSource& source);

private:
    host::Gpu& gpu_;
    const MeasureFolder& folder_;

    // Of the environment and the exponent at hand.
    std::string environment_;
    std::optional<float> exponent_;
    std::map<std::uint32_t, host::GpuEnvironment> uploads_; // by face size
    std::map<std::uint32_t, double> yardsticks_;            // likewise

    host::Outcome<const host::GpuEnvironment*> upload(const MeasureSource& source,
                                                      std::uint32_t face);
    host::Outcome<double> yardstick(std::uint32_t face);
    host::Outcome<host::Measured> prefilter(const MeasureCase& what,
                                            const host::GpuEnvironment& environment);
    host::Outcome<host::Measured> exact_prefilter(const MeasureCase& what,
                                                  const MeasureSource& source);
    host::Outcome<host::Measured> shade(const MeasureCase& what,
                                        const host::GpuEnvironment& environment);
    host::Outcome<host::Measured> reference(const MeasureCase& what, const MeasureSource& source);
};

} // namespace lobelia::cli
