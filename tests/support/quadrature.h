#pragma once

#include <cmath>
#include <vector>

namespace lobelia::oracle {

/// Gauss-Legendre rule on [-1, 1]: exact for polynomials of degree 2 size - 1.
struct GaussRule {
    std::vector<double> at;
    std::vector<double> weight;

    int size() const { return int(at.size()); }
};

inline constexpr int MAX_GAUSS_POINTS = 64;

/// The rule of `points` points, 1 to MAX_GAUSS_POINTS; made once, safe from any thread.
const GaussRule& gauss(int points);

/// Integral of f over [0, 1] by the tanh-sinh rule (Takahasi & Mori 1974, "Double Exponential
/// Formulas for Numerical Integration"), for f analytic inside, with any integrable singularity at
/// the ends. f is called as f(x, 1 - x), both without cancellation. Error below 1e-13 of the
/// largest |f| at `step` 1/32.
template <class Function>
double tanh_sinh(Function f, double step = 1.0 / 32) {
    double sum = 0;
    const int count = int(4.6 / step);
    for (int i = -count; i <= count; ++i) {
        const double t = i * step;
        const double stretch = std::acos(-1.0) * std::sinh(t);
        const double x = 1.0 / (1.0 + std::exp(-stretch));
        const double rest = 1.0 / (1.0 + std::exp(stretch));
        sum += f(x, rest) * x * rest * std::acos(-1.0) * std::cosh(t);
    }
    return sum * step;
}

} // namespace lobelia::oracle
