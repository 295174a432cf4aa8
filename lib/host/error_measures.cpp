#include <lobelia/host/error_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lobelia::host {

namespace {

constexpr double DARKEST = 1e-3; // of the mean: what is darker is not weighed by its own darkness

double over(double part, double whole) {
    if (whole > 0.0) return part / whole;
    return part > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

} // namespace

ErrorMeasures measure_error(std::span<const float> values, std::span<const float> exact) {
    const auto count = double(exact.size());
    double sum = 0.0, exact_sum = 0.0, magnitude = 0.0, squares = 0.0, exact_squares = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double value = double(values[i]), truth = double(exact[i]);
        sum += value;
        exact_sum += truth;
        magnitude += std::abs(truth);
        squares += (value - truth) * (value - truth);
        exact_squares += truth * truth;
    }
    std::vector<double> errors(exact.size());
    double error_squares = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double truth = double(exact[i]);
        errors[i] = over(std::abs(double(values[i]) - truth),
                         std::abs(truth) + DARKEST * magnitude / count);
        error_squares += errors[i] * errors[i];
    }
    std::sort(errors.begin(), errors.end());
    return {.rms = std::sqrt(error_squares / count),
            .p999 = errors[std::size_t(std::ceil(0.999 * count)) - 1],
            .max = errors.back(),
            .image_rms = std::sqrt(over(squares, exact_squares)),
            .mean_ratio = sum == exact_sum ? 1.0 : over(sum, exact_sum)};
}

} // namespace lobelia::host
