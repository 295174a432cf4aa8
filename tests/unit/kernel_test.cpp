#include "kernel.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/harmonics.h"
#include "support/quadrature.h"

namespace lobelia {
namespace {

constexpr double NONE = std::numeric_limits<double>::infinity();

TEST(KernelTest, KnowsTheLobesEigenvalues) {
    for (double exponent : {0.0, 0.5, 1.0, 3.0, 4.8, 16.0, 45.0, 700.0, 1e4, 1e6}) {
        const std::vector<double> lambda = lobe_eigenvalues(exponent, 29);
        ASSERT_EQ(lambda.size(), 29u);
        for (int l = 0; l < 29; ++l)
            EXPECT_NEAR(lambda[std::size_t(l)], oracle::lobe_eigenvalue(exponent, l), 1e-13)
                << "exponent " << exponent << " degree " << l;
    }
}

// The oracle has the same recurrence, so the integral it solves is checked too.
TEST(KernelTest, KnowsTheIntegralsOfTheLobeTimesLegendrePolynomials) {
    for (double exponent : {0.0, 1.0, 2.5, 4.8, 45.0, 700.0}) {
        const std::vector<double> lambda = lobe_eigenvalues(exponent, 12);
        for (int l = 0; l < 12; ++l) {
            const double integral =
                (exponent + 1) * oracle::tanh_sinh([&](double cosine, double) {
                    return std::pow(cosine, exponent) * oracle::legendre(l, cosine);
                });
            EXPECT_NEAR(lambda[std::size_t(l)], integral, 1e-11)
                << "exponent " << exponent << " degree " << l;
        }
    }
}

TEST(KernelTest, TakesAnInfiniteExponentForNoBlur) {
    for (double lambda : lobe_eigenvalues(NONE, 29)) EXPECT_EQ(lambda, 1);
}

TEST(KernelTest, AsksForNoMoreEigenvaluesThanCounted) {
    EXPECT_EQ(lobe_eigenvalues(7, 0).size(), 0u);
    EXPECT_EQ(lobe_eigenvalues(7, 1), std::vector<double>{1});
}

// lambda_1 and lambda_2 of the kernel as it is applied, cut off at its last chord.
Spectrum spectrum_of(const Kernel& kernel) {
    constexpr int PIECES = 64;
    const oracle::GaussRule& rule = oracle::gauss(16);
    double sums[3] = {};
    for (int piece = 0; piece < PIECES; ++piece)
        for (std::size_t i = 0; i < 16; ++i) {
            const double t = kernel.last_chord * (piece + 0.5 + 0.5 * rule.at[i]) / PIECES;
            const double weight =
                rule.weight[i] *
                std::exp(-kernel.sharpness * (t + kernel.quadratic * t * t + t * t * t / 3));
            for (int l = 0; l < 3; ++l) sums[l] += weight * oracle::legendre(l, 1 - t);
        }
    return {sums[1] / sums[0], sums[2] / sums[0]};
}

struct Step {
    double from; // exponent of the source's lobe
    double to;
    double cut; // in standard deviations
};
std::ostream& operator<<(std::ostream& out, const Step& step) {
    return out << step.from << " to " << step.to << " cut at " << step.cut;
}

class EveryStep : public testing::TestWithParam<Step> {};

// The chain's own: from the source, and from each level to the next and to maps.
INSTANTIATE_TEST_SUITE_P(Steps, EveryStep,
                         testing::Values(Step{NONE, 45, 3.5}, Step{NONE, 64, 4}, Step{NONE, 230, 4},
                                         Step{NONE, 507, 4.5}, Step{NONE, 2048, 3.6},
                                         Step{NONE, 1e4, 3.5}, Step{NONE, 1e6, 4.5},
                                         Step{507, 45, 3.5}, Step{507, 45, 4}, Step{507, 45, 4.5},
                                         Step{507, 230, 4}, Step{2028, 507, 3.5},
                                         Step{2028, 507, 4}, Step{2028, 507, 4.5},
                                         Step{8112, 2028, 4}));

// Of the blur, 1 - lambda: a quarter of what rounding to a half does to a texel.
constexpr double TOLERANCE = 0x1p-13;

TEST_P(EveryStep, HasTheSpectrumAskedForAfterItIsCut) {
    const Step step = GetParam();
    const double variance = 1 / step.to - 1 / step.from;
    const double last_chord = 1 - std::cos(std::min(step.cut * std::sqrt(variance), 1.3));
    const auto wanted = [&](int l) {
        return oracle::lobe_eigenvalue(step.to, l) /
               (std::isinf(step.from) ? 1 : oracle::lobe_eigenvalue(step.from, l));
    };
    const Kernel kernel = match_kernel({wanted(1), wanted(2)}, last_chord);
    EXPECT_EQ(kernel.last_chord, last_chord);
    EXPECT_GT(kernel.sharpness, 0);
    const Spectrum found = spectrum_of(kernel);
    for (int l : {1, 2}) {
        const double blur = 1 - wanted(l);
        EXPECT_NEAR((1 - found[std::size_t(l - 1)]) / blur, 1, TOLERANCE)
            << "degree " << l << " sharpness " << kernel.sharpness << " quadratic "
            << kernel.quadratic;
    }
}

} // namespace
} // namespace lobelia
