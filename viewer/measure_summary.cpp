#include "measure_summary.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "prefilter_method.h"
#include "quality.h"

namespace lobelia::cli {

namespace {

/// The mean of logarithms, as points on logarithmic axes have it.
class GeometricMean {
public:
    void add(double value) {
        sum_ += std::log(value);
        ++count_;
    }
    double value() const { return std::exp(sum_ / count_); }

private:
    double sum_ = 0.0;
    int count_ = 0;
};

MeasureWay way_of(const MeasureRow& row) {
    return {row.what.method, row.what.quality, row.what.samples};
}

struct Point {
    double ms, rms;
};

double between(double x, double x0, double x1, double y0, double y1) {
    return std::exp(std::log(y0) + std::log(x / x0) / std::log(x1 / x0) * std::log(y1 / y0));
}

/// On the line through `points`, which are sorted by time; before and after it, on its ends.
double error_in(double ms, const std::vector<Point>& points) {
    if (ms <= points.front().ms) return points.front().rms;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (ms < points[i].ms)
            return between(ms, points[i - 1].ms, points[i].ms, points[i - 1].rms, points[i].rms);
    return points.back().rms;
}

/// The first time at which that line is as low as `rms`; nothing where it never is.
std::optional<double> time_for(double rms, const std::vector<Point>& points) {
    if (rms >= points.front().rms) return points.front().ms;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (rms >= points[i].rms)
            return between(rms, points[i - 1].rms, points[i].rms, points[i - 1].ms, points[i].ms);
    return std::nullopt;
}

bool has_error(const MeasureRow& row) {
    return row.error.rms > 0.0 && std::isfinite(row.error.rms);
}

/// Ways in the order in which they were measured.
std::vector<MeasureWay> ways_of(const std::vector<MeasureRow>& rows, const std::string& task) {
    std::vector<MeasureWay> ways;
    for (const MeasureRow& row : rows)
        if (row.what.task == task && std::find(ways.begin(), ways.end(), way_of(row)) == ways.end())
            ways.push_back(way_of(row));
    return ways;
}

std::map<double, double> values(const std::map<double, GeometricMean>& means) {
    std::map<double, double> result;
    for (const auto& [at, mean] : means) result[at] = mean.value();
    return result;
}

} // namespace

std::string label_of(const MeasureWay& way) {
    return way.method + (way.quality ? " " + *way.quality : "") +
           (way.samples ? " " + std::to_string(*way.samples) : "");
}

MeasureSummary::MeasureSummary(const std::vector<MeasureRow>& rows,
                               const nlohmann::ordered_json& head)
    : device_(head.at("device").get<std::string>()) {
    by_device_ = head.at("device_type") != "cpu" &&
                 std::all_of(rows.begin(), rows.end(),
                             [](const MeasureRow& row) { return row.cost.gpu_ms.has_value(); });
    clock_ = by_device_ ? "time by the device's clock" : "CPU time of the process";
    std::map<std::string, std::uint32_t> faces;
    std::set<std::string> panoramas;
    for (const auto& environment : head.at("environments")) {
        const auto name = environment.at("name").get<std::string>();
        environments_.push_back(name);
        faces[name] = environment.at("face_size").get<std::uint32_t>();
        if (environment.at("panorama").get<bool>()) panoramas.insert(name);
    }
    const std::string high = quality_name(Quality::high);
    const std::string chain = prefilter_method_name(host::PrefilterMethod::chain);
    std::set<std::pair<std::string, float>> swept;
    for (const MeasureRow& row : rows) {
        const MeasureCase& what = row.what;
        const bool doubled = what.quality == high && panoramas.contains(what.environment);
        const bool own_size = what.face_size == faces[what.environment] * (doubled ? 2 : 1);
        if (own_size) rows_.push_back(row);
        if (!own_size) swept.emplace(what.environment, what.exponent);
    }
    for (const MeasureRow& row : rows)
        if (row.what.method == chain &&
            swept.contains(std::pair(row.what.environment, row.what.exponent)))
            sweep_.push_back(row);
}

double MeasureSummary::ms(const MeasureRow& row) const {
    return by_device_ ? *row.cost.gpu_ms : row.cost.cpu_ms;
}

std::vector<MeasureMean> MeasureSummary::means(const std::string& task) const {
    std::vector<MeasureMean> means;
    for (const MeasureWay& way : ways_of(rows_, task)) {
        GeometricMean time, error;
        bool exact = true;
        for (const MeasureRow& row : rows_) {
            if (row.what.task != task || way_of(row) != way) continue;
            time.add(ms(row));
            if (!has_error(row)) continue;
            error.add(row.error.rms);
            exact = false;
        }
        means.push_back({way, time.value(), exact ? std::nullopt : std::optional(error.value())});
    }
    return means;
}

std::vector<MeasureAdvantage> MeasureSummary::advantages() const {
    using Light = std::pair<std::string, float>;
    std::map<Light, std::vector<Point>> sampled;
    const std::string filtered = prefilter_method_name(host::PrefilterMethod::filtered_importance);
    for (const MeasureRow& row : rows_)
        if (row.what.method == filtered && has_error(row))
            sampled[{row.what.environment, row.what.exponent}].push_back({ms(row), row.error.rms});
    for (auto& [light, points] : sampled)
        std::sort(points.begin(), points.end(),
                  [](const Point& a, const Point& b) { return a.ms < b.ms; });

    struct Sums {
        GeometricMean error, time;
        bool at_least = false;
    };
    std::vector<std::pair<std::string, Sums>> sums; // in the order in which they were measured
    const std::string chain = prefilter_method_name(host::PrefilterMethod::chain);
    for (const MeasureRow& row : rows_) {
        const MeasureCase& what = row.what;
        if (what.method != chain || what.exponent < 16.0f || what.exponent > 1024.0f) continue;
        const auto beside = sampled.find({what.environment, what.exponent});
        if (beside == sampled.end() || !has_error(row)) continue;
        auto found = std::find_if(sums.begin(), sums.end(),
                                  [&](const auto& sum) { return sum.first == *what.quality; });
        if (found == sums.end()) found = sums.insert(found, {*what.quality, {}});
        const auto time = time_for(row.error.rms, beside->second);
        found->second.error.add(error_in(ms(row), beside->second) / row.error.rms);
        found->second.time.add(time.value_or(beside->second.back().ms) / ms(row));
        found->second.at_least |= !time;
    }
    std::vector<MeasureAdvantage> advantages;
    for (const auto& [quality, sum] : sums)
        advantages.push_back({quality, sum.error.value(), sum.time.value(), sum.at_least});
    return advantages;
}

std::vector<MeasureLine> MeasureSummary::errors_by_exponent(const std::string& task) const {
    std::vector<MeasureLine> lines;
    for (const MeasureWay& way : ways_of(rows_, task)) {
        std::map<double, GeometricMean> errors;
        for (const MeasureRow& row : rows_)
            if (row.what.task == task && way_of(row) == way && has_error(row))
                errors[double(row.what.exponent)].add(row.error.rms);
        if (!errors.empty()) lines.push_back({way, values(errors)});
    }
    return lines;
}

std::vector<MeasureLine> MeasureSummary::costs_by_face() const {
    std::vector<MeasureLine> lines;
    for (const MeasureWay& way : ways_of(sweep_, "prefilter")) {
        std::map<double, GeometricMean> costs;
        for (const MeasureRow& row : sweep_)
            if (way_of(row) == way) costs[row.what.face_size].add(ms(row));
        lines.push_back({way, values(costs)});
    }
    std::map<double, GeometricMean> yardsticks;
    for (const MeasureRow& row : sweep_) yardsticks[row.what.face_size].add(row.yardstick_ms);
    if (!by_device_ && !yardsticks.empty()) lines.push_back({{}, values(yardsticks)});
    return lines;
}

std::optional<double> MeasureSummary::yardstick() const {
    if (by_device_ || rows_.empty()) return std::nullopt;
    GeometricMean mean;
    for (const MeasureRow& row : rows_) mean.add(row.yardstick_ms);
    return mean.value();
}

std::vector<MeasureMean> pareto_front(std::vector<MeasureMean> means) {
    std::erase_if(means, [](const MeasureMean& mean) { return !mean.rms; });
    std::sort(means.begin(), means.end(), [](const MeasureMean& a, const MeasureMean& b) {
        return std::pair(a.ms, *a.rms) < std::pair(b.ms, *b.rms);
    });
    std::vector<MeasureMean> front;
    for (const MeasureMean& mean : means)
        if (front.empty() || *mean.rms < *front.back().rms) front.push_back(mean);
    return front;
}

} // namespace lobelia::cli
