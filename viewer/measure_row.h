#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lobelia/host/error_measures.h>
#include <lobelia/host/measure.h>

namespace lobelia::cli {

/// What one measurement is of.
struct MeasureCase {
    std::string task;   // prefilter or shade
    std::string method; // as on the command line
    std::optional<std::uint32_t> samples;
    std::optional<std::string> quality;
    std::string environment;
    float exponent = 1.0f;
    std::uint32_t face_size = 0; // edge of the environment's cube map, texels

    bool operator==(const MeasureCase&) const = default;
};

/// One measurement.
struct MeasureRow {
    MeasureCase what;
    host::ErrorMeasures error;
    host::Cost cost;
    double yardstick_ms = 0.0; // CPU time of a mip chain of the same cube map, in the same run
};

/// One object with a key for each column of the CSV file; what does not apply is null.
nlohmann::ordered_json as_json(const MeasureRow& row);

/// Throws nlohmann's exceptions where a key is missing or has another type.
MeasureRow row_from_json(const nlohmann::ordered_json& object);

/// A line of names and a line for each row; what does not apply is empty.
std::string as_csv(const std::vector<MeasureRow>& rows);

/// A cost as an object, and back.
nlohmann::ordered_json as_json(const host::Cost& cost);
host::Cost cost_from_json(const nlohmann::ordered_json& object);

} // namespace lobelia::cli
