#pragma once

#include <span>

namespace lobelia::oracle {

/// How far `actual` is from `exact`, over directions or pixels of one channel. The pointwise error
/// is |actual - exact| / (|exact| + 1e-3 mean |exact|), so black counts against the image's mean.
struct ErrorMeasures {
    double pointwise_rms = 0;
    double pointwise_p999 = 0; // 99.9 % of the points are at or below it
    double pointwise_max = 0;
    double image_rms = 0;  // root mean square of the difference over that of `exact`
    double mean_ratio = 1; // mean of `actual` over mean of `exact`
};

/// Spans of the same size, at least 1. Any NaN makes every measure NaN. All-black against all-black
/// is no error; all-black `exact` under anything else is an infinite one.
ErrorMeasures measure_error(std::span<const double> actual, std::span<const double> exact);
ErrorMeasures measure_error(std::span<const float> actual, std::span<const double> exact);

} // namespace lobelia::oracle
