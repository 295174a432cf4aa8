#pragma once

#include <map>

#include "measure_row.h"

namespace lobelia::cli {

/// A way to do a task: what a point or a line of the pictures stands for.
struct MeasureWay {
    std::string method;
    std::optional<std::string> quality;
    std::optional<std::uint32_t> samples;

    auto operator<=>(const MeasureWay&) const = default;
};

/// As in "chain normal" or "importance 64".
std::string label_of(const MeasureWay& way);

/// Geometric means over environments and exponents. No error: exact.
struct MeasureMean {
    MeasureWay way;
    double ms = 0.0;
    std::optional<double> rms;
};

/// How a quality of the prefilter stands to filtered importance sampling, whose error over time is
/// taken for a line between its numbers of samples, on logarithmic axes; before the least of them
/// it is that one's error. Geometric means over environments and the exponents from 16 to 1024.
struct MeasureAdvantage {
    std::string quality;
    double error = 0.0;    // of sampling over the chain's, in the chain's time
    double time = 0.0;     // of sampling over the chain's, for the chain's error
    bool at_least = false; // where the most samples did not reach that error, their time stands in
};

/// A line of a picture.
struct MeasureLine {
    MeasureWay way;
    std::map<double, double> points; // geometric means over environments
};

/// What pictures show of measurements: errors are pointwise RMS, times those of the device's clock
/// where it is no CPU, else the process's.
class MeasureSummary {
public:
    /// `head` is all of measure.json but the rows.
    MeasureSummary(const std::vector<MeasureRow>& rows, const nlohmann::ordered_json& head);

    const std::string& device() const { return device_; }
    const std::string& clock() const { return clock_; }
    const std::vector<std::string>& environments() const { return environments_; }

    std::vector<MeasureMean> means(const std::string& task) const;
    /// None where sampling or the chain was not measured.
    std::vector<MeasureAdvantage> advantages() const;
    std::vector<MeasureLine> errors_by_exponent(const std::string& task) const;
    /// Milliseconds of the prefilter's chain by the face size of the environment's cube map; the
    /// last line, without a way, is the yardstick.
    std::vector<MeasureLine> costs_by_face() const;
    /// The yardstick for the environments as they are, where its clock is that of the times.
    std::optional<double> yardstick() const;

private:
    std::string device_, clock_;
    std::vector<std::string> environments_;
    bool by_device_ = false;
    std::vector<MeasureRow> rows_;  // of environments in their own size
    std::vector<MeasureRow> sweep_; // of one environment in several

    double ms(const MeasureRow& row) const;
};

/// Of `means`, those that nothing is both faster and more exact than, by rising time.
std::vector<MeasureMean> pareto_front(std::vector<MeasureMean> means);

} // namespace lobelia::cli
