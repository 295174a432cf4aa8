#include "kernel.h"

#include <cmath>

namespace lobelia {

std::vector<double> lobe_eigenvalues(double n, std::size_t count) {
    std::vector<double> lambda(count, 1.0);
    if (std::isinf(n)) return lambda;
    if (count > 1) lambda[1] = (n + 1) / (n + 2);
    for (std::size_t l = 2; l < count; ++l)
        lambda[l] = lambda[l - 2] * (n - double(l) + 2) / (n + double(l) + 1);
    return lambda;
}

namespace {

Spectrum spectrum_of(const Kernel& kernel) {
    constexpr int INTERVALS = 128; // of Simpson's rule: eight digits and more
    double mass = 0, first = 0, second = 0;
    for (int i = 0; i <= INTERVALS; ++i) {
        const double t = kernel.last_chord * i / INTERVALS;
        const double share = i == 0 || i == INTERVALS ? 1 : i % 2 ? 4 : 2;
        const double weight =
            share * std::exp(-kernel.sharpness * t * (1 + t * (kernel.quadratic + t / 3)));
        const double cosine = 1 - t;
        mass += weight;
        first += weight * cosine;
        second += weight * (1.5 * cosine * cosine - 0.5);
    }
    return {first / mass, second / mass};
}

// lambda_1 grows with the sharpness.
double match_first(Kernel kernel, double lambda_1) {
    double low = 1e-3, high = 1e7;
    for (int i = 0; i < 60; ++i) {
        kernel.sharpness = std::sqrt(low * high);
        (spectrum_of(kernel)[0] < lambda_1 ? low : high) = kernel.sharpness;
    }
    return std::sqrt(low * high);
}

} // namespace

Kernel match_kernel(const Spectrum& spectrum, double last_chord) {
    Kernel kernel{0, 0.5, last_chord};
    // At equal lambda_1, a larger quadratic term means lighter tails and a smaller lambda_2.
    double low = -0.6, high = 4;
    for (int i = 0; i < 30; ++i) {
        kernel.quadratic = (low + high) / 2;
        kernel.sharpness = match_first(kernel, spectrum[0]);
        (spectrum_of(kernel)[1] > spectrum[1] ? low : high) = kernel.quadratic;
    }
    return kernel;
}

} // namespace lobelia
