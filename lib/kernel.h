#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lobelia {

/// A kernel of the zonal chain: exp(-sharpness (t + quadratic t^2 + t^3 / 3)) of the chord t, which
/// is 1 - cos(angle), up to `last_chord`. docs/prefilter.md derives it.
struct Kernel {
    double sharpness;
    double quadratic;
    double last_chord;
};

/// Eigenvalues lambda_1 and lambda_2 of a zonal kernel with unit mean.
using Spectrum = std::array<double, 2>;

/// lambda_0 to lambda_(count - 1) of the lobe cos^n: Funk-Hecke. An infinite exponent blurs
/// nothing.
std::vector<double> lobe_eigenvalues(double exponent, std::size_t count);

/// The kernel that has this spectrum after it has been cut off at `last_chord`.
Kernel match_kernel(const Spectrum& spectrum, double last_chord);

} // namespace lobelia
