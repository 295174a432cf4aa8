#include "support/harmonics.h"

#include <cstdlib>

namespace lobelia::oracle {

double legendre(int l, double x) {
    double before = 0;
    double value = 1;
    for (int k = 1; k <= l; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return value;
}

double harmonic(int l, int m, Direction d) {
    const int order = std::abs(m);
    const double across = std::hypot(d.x, d.z);
    const double longitude = std::atan2(d.x, d.z);

    // Normalised associated Legendre functions, from degree = order upwards.
    double value = std::sqrt(1 / (4 * PI));
    for (int k = 1; k <= order; ++k) value *= across * std::sqrt((2 * k + 1.0) / (2 * k));
    double before = 0;
    double old_factor = 0;
    for (int k = order + 1; k <= l; ++k) {
        const double factor = std::sqrt((4.0 * k * k - 1) / (double(k) * k - order * order));
        const double next = factor * (d.y * value - (old_factor == 0 ? 0 : before / old_factor));
        before = value;
        value = next;
        old_factor = factor;
    }
    if (m == 0) return value;
    return std::sqrt(2.0) * value *
           (m > 0 ? std::cos(order * longitude) : std::sin(order * longitude));
}

double lobe_eigenvalue(double n, int l) {
    double value = l % 2 == 0 ? 1 : (n + 1) / (n + 2);
    for (int k = l % 2 == 0 ? 2 : 3; k <= l; k += 2) value *= (n - k + 2) / (n + k + 1);
    return value;
}

} // namespace lobelia::oracle
