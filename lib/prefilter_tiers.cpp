#include "prefilter_tiers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel.h"
#include "prefilter_plan.h"

namespace lobelia {

namespace {

constexpr Tier TIERS[] = {
    {0.95, 1.4, 3.75, 3.6, 2e-3, 40, 40},
    {1.23, 2.0, 4.0, 3.6, 1e-4, 36, 64},
    {1.7, 2.8, 4.5, 4.5, 3e-5, 8, 64},
};
constexpr std::uint32_t MANY = 200;    // degrees: what is left is below any tolerance
constexpr std::uint32_t SIZE_STEP = 8; // of maps

} // namespace

const Tier& tier_of(Quality quality) {
    return TIERS[std::size_t(quality)];
}

double sharpest_for(double size, double texels_per_sigma) {
    return std::pow(size / (2 * texels_per_sigma), 2);
}

std::uint32_t in_steps(double needed, std::uint32_t least, std::uint32_t largest) {
    const double steps = std::ceil(std::min(needed, double(largest)) / SIZE_STEP - 1e-3);
    return std::min(std::max(std::uint32_t(steps) * SIZE_STEP, least), largest);
}

std::uint32_t size_for(double exponent, const Tier& tier, std::uint32_t largest) {
    const std::uint32_t least = exponent > tier.coarse_exponent ? tier.fine_size : LEAST_MAP_SIZE;
    return in_steps(2 * tier.texels_per_sigma * std::sqrt(exponent), least, largest);
}

double texel_variance(std::uint32_t size, double texels_squared) {
    return texels_squared * 4.0 / (double(size) * size);
}

double mean_on_sphere(double face_variance) {
    constexpr int N = 64;
    double sum = 0, weights = 0;
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) {
            const double u = (i + 0.5) / N, v = (j + 0.5) / N;
            const double square = 1 + u * u + v * v;
            const double weight = std::pow(square, -1.5);
            sum += weight * 0.5 * (1 / square + 1 / (square * square));
            weights += weight;
        }
    return face_variance * sum / weights;
}

std::uint32_t degrees_for(double exponent, double tolerance) {
    const std::vector<double> lambda = lobe_eigenvalues(exponent, MANY);
    double left = 0;
    std::uint32_t degrees = MANY;
    for (; degrees > 1; --degrees) {
        const double l = double(degrees - 1);
        left += (2 * l + 1) * lambda[degrees - 1] * lambda[degrees - 1];
        if (left > tolerance * tolerance) break;
    }
    return std::min(degrees, DEGREES);
}

} // namespace lobelia
