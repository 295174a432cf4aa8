#include "support/error_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace lobelia::oracle {
namespace {

double ratio(double part, double whole) {
    if (whole != 0) return part / whole;
    return part == 0 ? 0 : std::numeric_limits<double>::infinity();
}

} // namespace

ErrorMeasures measure_error(std::span<const double> actual, std::span<const double> exact) {
    assert(actual.size() == exact.size() && !exact.empty());
    const auto count = double(exact.size());
    double magnitude = 0;
    double actual_sum = 0;
    double exact_sum = 0;
    double difference_squares = 0;
    double exact_squares = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double difference = actual[i] - exact[i];
        if (std::isnan(difference)) {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            return {nan, nan, nan, nan, nan};
        }
        magnitude += std::abs(exact[i]) / count;
        actual_sum += actual[i];
        exact_sum += exact[i];
        difference_squares += difference * difference;
        exact_squares += exact[i] * exact[i];
    }

    std::vector<double> errors(exact.size());
    double squares = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        errors[i] = ratio(std::abs(actual[i] - exact[i]), std::abs(exact[i]) + 1e-3 * magnitude);
        squares += errors[i] * errors[i];
    }
    std::sort(errors.begin(), errors.end());
    ErrorMeasures measures;
    measures.pointwise_rms = std::sqrt(squares / count);
    measures.pointwise_p999 = errors[std::size_t(std::ceil(0.999 * count)) - 1];
    measures.pointwise_max = errors.back();
    measures.image_rms = std::sqrt(ratio(difference_squares, exact_squares));
    measures.mean_ratio = actual_sum == exact_sum ? 1 : ratio(actual_sum, exact_sum);
    return measures;
}

ErrorMeasures measure_error(std::span<const float> actual, std::span<const double> exact) {
    return measure_error(std::vector<double>(actual.begin(), actual.end()), exact);
}

} // namespace lobelia::oracle
