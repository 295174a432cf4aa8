#pragma once

#include <span>

namespace lobelia::host {

/// How far values are from the exact ones. The pointwise error is
/// |value - exact| / (|exact| + 1e-3 mean |exact|), so that black counts against the mean.
struct ErrorMeasures {
    double rms = 0.0;        // of the pointwise errors
    double p999 = 0.0;       // 99.9 % of the pointwise errors are at or below it
    double max = 0.0;        // the largest pointwise error
    double image_rms = 0.0;  // root mean square of the differences over that of `exact`
    double mean_ratio = 1.0; // mean of the values over mean of `exact`
};

/// Spans of the same size, at least 1, of finite values. Where `exact` is black everywhere, black
/// is no error and all else an infinite one.
ErrorMeasures measure_error(std::span<const float> values, std::span<const float> exact);

} // namespace lobelia::host
