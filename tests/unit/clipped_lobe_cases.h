#pragma once

#include <cmath>
#include <vector>

namespace lobelia {

inline const std::vector<double> EXPONENTS{0, 0.01, 0.3, 1, 1.7, 4.8, 16, 64, 300, 1024, 3e4, 1e6};

/// From the horizon over the widths of the lobe to the pole, both ends included.
inline std::vector<double> cosines(double exponent, int count) {
    std::vector<double> all;
    const double width = 1 / std::sqrt(exponent + 1);
    for (int i = 0; i <= count; ++i) {
        const double column = double(i) / count;
        const double height = 2 * width * column / (1 + 2 * width - column);
        all.push_back(1 - (1 - height) * (1 - height));
    }
    return all;
}

inline double sine_of(double cosine) {
    return std::sqrt((1 - cosine) * (1 + cosine));
}

} // namespace lobelia
