#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <lobelia/lobe.h>

#include "support/quadrature.h"

namespace lobelia {
namespace {

constexpr double DOCUMENTED_ERROR = 1e-6;

const std::vector<float> EXPONENTS{0.0f, 1e-30f, 1e-6f, 0.01f, 0.3f,   1.0f,     1.7f,
                                   2.0f, 4.8f,   8.0f,  16.0f, 40.0f,  64.0f,    200.0f,
                                   1e3f, 4096.f, 1e4f,  1e5f,  3.3e5f, 999999.f, 1e6f};

// Cosines over [0, 1] and, closer, over the last sigmas of the lobe above the horizon.
std::vector<float> cosines(float exponent) {
    std::vector<float> all;
    for (int i = 0; i <= 20; ++i) {
        all.push_back(float(i) / 20.0f);
        all.push_back(float(i) / 4.0f / std::sqrt(exponent + 25.0f));
    }
    return all;
}

// Integral of f over [a, b], with any weak singularity at the ends.
template <class Function>
double integrate(double a, double b, Function f) {
    if (b <= a) return 0;
    return (b - a) *
           oracle::tanh_sinh([&](double x, double) { return f(a + (b - a) * x); }, 1.0 / 16);
}

// The definition: over the directions w at `theta` from R and `azimuth` about it, the part above
// the horizon. Cut where the horizon first touches a circle of constant theta.
double integrate_definition(double cosine, double exponent) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const auto circle = [&](double theta) {
        const double across = sine * std::sin(theta);
        const double along = cosine * std::cos(theta);
        const double edge = along >= across ? std::numbers::pi : std::acos(-along / across);
        const double above = 2 * integrate(0, edge, [&](double azimuth) {
                                 return along + across * std::cos(azimuth);
                             });
        return std::pow(std::cos(theta), exponent) * std::sin(theta) * above;
    };
    const double reach = std::min(std::numbers::pi / 2, 9 / std::sqrt(exponent + 1e-9));
    const double touch = std::min(std::asin(cosine), reach);
    return (exponent + 2) / (2 * std::numbers::pi) *
           (integrate(0, touch, circle) + integrate(touch, reach, circle));
}

// The closed form of docs/albedo.md, its integral taken numerically; for exponents above 0.
double closed_form(double c, double n) {
    const double horizon = std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 1)) /
                           (2 * std::sqrt(std::numbers::pi));
    // s = tanh(r): the integrand becomes cosh(r)^-n
    const double end = std::min(400.0, 40 / n + 9 / std::sqrt(n));
    const double start = std::atanh(c);
    const double tail = integrate(start, std::max(start, end),
                                  [n](double r) { return std::pow(std::cosh(r), -n); });
    return c + horizon * (std::pow((1 - c) * (1 + c), n / 2) - n * c * tail);
}

TEST(PhongAlbedo, IsItsDefinition) {
    for (float n : EXPONENTS)
        for (float c : cosines(n))
            ASSERT_NEAR(phong_albedo(c, n), integrate_definition(c, n), DOCUMENTED_ERROR)
                << "cosine " << c << ", exponent " << n;
}

TEST(PhongAlbedo, HasTheClosedForm) {
    // A cosine off by 1e-16 shows in its millionth power as 1e-10.
    for (float n : {0.5f, 1.0f, 4.8f, 64.0f, 1e4f, 1e6f})
        for (float c : {0.0f, 1e-4f, 1e-3f, 0.01f, 0.1f, 0.5f, 0.9f})
            EXPECT_NEAR(closed_form(c, n), integrate_definition(c, n), 1e-9)
                << "cosine " << c << ", exponent " << n;
}

TEST(PhongAlbedo, HoldsBetweenTheExponentsOfTheDefinition) {
    for (double n = 0.3; n < 1e6; n *= 1.13)
        for (int i = 0; i < 64; ++i) {
            const float c = float(i) / 63.0f * float(std::min(0.99, 7 / std::sqrt(n)));
            ASSERT_NEAR(phong_albedo(c, float(n)), closed_form(c, float(n)), DOCUMENTED_ERROR)
                << "cosine " << c << ", exponent " << n;
        }
}

TEST(PhongAlbedo, IsOneWhereTheLobeStandsOnTheNormal) {
    for (float n : EXPONENTS) EXPECT_EQ(phong_albedo(1.0f, n), 1.0f) << "exponent " << n;
}

TEST(PhongAlbedo, HasItsKnownValues) {
    EXPECT_NEAR(phong_albedo(0.0f, 1.0f), std::numbers::inv_pi, DOCUMENTED_ERROR);
    for (float c = 0.0f; c <= 1.0f; c += 1.0f / 64)
        EXPECT_NEAR(phong_albedo(c, 0.0f), (1 + c) / 2, DOCUMENTED_ERROR) << "cosine " << c;
}

TEST(PhongAlbedo, RisesWithTheCosineAndStaysWithinOne) {
    for (float n : EXPONENTS) {
        float before = 0.0f;
        for (int i = 0; i <= 4096; ++i) {
            const float c = float(i) / 4096.0f;
            const float value = phong_albedo(c, n);
            ASSERT_GT(value, before) << "cosine " << c << ", exponent " << n;
            ASSERT_GE(value, c) << "cosine " << c << ", exponent " << n;
            ASSERT_LE(value, 1.0f) << "cosine " << c << ", exponent " << n;
            before = value;
        }
    }
}

TEST(PhongAlbedo, TakesACosineThatRoundingPushedOut) {
    for (float n : EXPONENTS) {
        EXPECT_EQ(phong_albedo(-1e-6f, n), phong_albedo(0.0f, n));
        EXPECT_EQ(phong_albedo(1.0f + 1e-6f, n), 1.0f);
    }
}

} // namespace
} // namespace lobelia
