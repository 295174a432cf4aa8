#include "clipped_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/oracle.h"
#include "support/quadrature.h"

namespace lobelia {
namespace {

using oracle::Direction;

const std::vector<double> EXPONENTS{0, 0.01, 0.3, 1, 1.7, 4.8, 16, 64, 300, 1024, 3e4, 1e6};

// From the horizon over the widths of the lobe to the pole, both ends included.
std::vector<double> cosines(double exponent, int count) {
    std::vector<double> all;
    const double width = 1 / std::sqrt(exponent + 1);
    for (int i = 0; i <= count; ++i) {
        const double column = double(i) / count;
        const double height = 2 * width * column / (1 + 2 * width - column);
        all.push_back(1 - (1 - height) * (1 - height));
    }
    return all;
}

double sine_of(double cosine) {
    return std::sqrt((1 - cosine) * (1 + cosine));
}

// Mean of value(w) over the lobe by its definition: in polar coordinates about R = +z, N in the
// plane y = 0, the part above the horizon. Cut where the horizon first touches a circle around R.
template <class Function>
double mean_by_definition(double cosine, double exponent, Function value) {
    const double sine = sine_of(cosine);
    const auto integrate = [](double a, double b, auto f) {
        return b <= a
                   ? 0
                   : (b - a) * oracle::tanh_sinh(
                                   [&](double x, double) { return f(a + (b - a) * x); }, 1.0 / 16);
    };
    const auto over_sphere = [&](auto function) {
        const auto circle = [&](double theta) {
            const double across = sine * std::sin(theta), along = cosine * std::cos(theta);
            const double edge = along >= across ? std::numbers::pi : std::acos(-along / across);
            return std::pow(std::cos(theta), exponent) * std::sin(theta) *
                   integrate(0, edge, [&](double azimuth) {
                       const Direction w{std::sin(theta) * std::cos(azimuth),
                                         std::sin(theta) * std::sin(azimuth), std::cos(theta)};
                       return (cosine * w.z + sine * w.x) * function(w);
                   });
        };
        const double reach = std::min(std::numbers::pi / 2, 9 / std::sqrt(exponent + 1e-9));
        const double touch = std::min(std::asin(cosine), reach);
        return integrate(0, touch, circle) + integrate(touch, reach, circle);
    };
    return over_sphere(value) / over_sphere([](Direction) { return 1.0; });
}

TEST(ClippedLobe, HasTheMomentsOfItsDefinition) {
    for (double n : {0.0, 0.3, 1.0, 4.8, 64.0, 1024.0, 1e6})
        for (double c : cosines(n, 4)) {
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            const ClippedMoments moments = clipped_moments(c, n);
            const double sin_shift = std::sin(moments.shift), cos_shift = std::cos(moments.shift);
            const double width = 1 / std::sqrt(n + 1);
            const auto mean = [&](auto value) { return mean_by_definition(c, n, value); };

            // The oracle's rule at this step is good for nine digits.
            constexpr double SHARE = 1e-8;
            const double half = moments.shift / 2;
            EXPECT_NEAR(mean([&](Direction w) { return w.x * cos_shift - w.z * sin_shift; }), 0,
                        SHARE * width);
            EXPECT_NEAR(mean([&](Direction w) {
                            // 1 - w.axis as half a squared distance, which cancels nothing
                            const double x = w.x - sin_shift,
                                         z = w.z - 1 + 2 * std::sin(half) * std::sin(half);
                            return (x * x + w.y * w.y + z * z) / 2;
                        }),
                        moments.deficit, SHARE * moments.deficit + 1e-16);
            EXPECT_NEAR(mean([&](Direction w) {
                            const double side = w.x * cos_shift - w.z * sin_shift;
                            return side * side;
                        }),
                        moments.in_plane, SHARE * moments.in_plane);
            EXPECT_NEAR(mean([](Direction w) { return w.y * w.y; }), moments.across,
                        SHARE * moments.across);
        }
}

TEST(ClippedLobe, HasItsMeanWhereTheAlbedoSays) {
    // mean w.R = (n + 2) / (n + 3) W(c, n + 1) / W(c, n), straight from the definitions
    for (double n : {0.0, 0.3, 1.0, 4.8, 64.0, 1024.0, 3e4})
        for (double c : cosines(n, 8)) {
            const ClippedMoments moments = clipped_moments(c, n);
            EXPECT_NEAR((1 - moments.deficit) * std::cos(moments.shift),
                        (n + 2) / (n + 3) * oracle::albedo(c, n + 1) / oracle::albedo(c, n), 1e-9)
                << "cosine " << c << ", exponent " << n;
        }
}

TEST(ClippedLobe, IsAFlatGaussianCutByALineWhenItIsSharp) {
    // In standard deviations, with the horizon at -x: density phi(u) (x + u) for u > -x has mass
    // A = phi + x Phi, mean Phi / A and mean square 1 + phi / A.
    constexpr double n = 1e6;
    for (double x : {0.0, 0.3, 1.0, 2.0, 4.0, 8.0}) {
        const double phi = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
        const double below = std::erfc(-x / std::sqrt(2.0)) / 2;
        const double mass = phi + x * below;
        const double mean = below / mass;
        const double variance = 1 + phi / mass - mean * mean;

        // Terms left out are a few times 1 / n; x itself is tan or sin to x^2 / n.
        constexpr double TOLERANCE = 1e-4;
        const MatchedTaps taps = matched_taps(x / std::sqrt(n), n);
        EXPECT_NEAR(taps.shift * std::sqrt(n), mean, TOLERANCE) << x;
        EXPECT_NEAR(n / taps.one_tap_exponent, (1 + variance) / 2, TOLERANCE) << x;
        EXPECT_NEAR(n / taps.two_tap_exponent, variance, TOLERANCE) << x;
        EXPECT_NEAR(taps.two_tap_angle * std::sqrt(n), std::sqrt(1 - variance), TOLERANCE) << x;
    }
}

TEST(ClippedLobe, IsTheLobeOfTheNextExponentAtThePole) {
    for (double n : EXPONENTS) {
        const MatchedTaps taps = matched_taps(1, n);
        EXPECT_EQ(taps.shift, 0) << n;
        EXPECT_NEAR(taps.one_tap_exponent / (n + 1), 1, 1e-8) << n;
        EXPECT_NEAR(taps.two_tap_exponent / (n + 1), 1, 1e-8) << n;
        EXPECT_EQ(taps.two_tap_angle, 0) << n;
    }
}

TEST(ClippedLobe, HasTapsOfItsOwnMoments) {
    for (double n : EXPONENTS)
        for (double c : cosines(n, 16)) {
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            const ClippedMoments moments = clipped_moments(c, n);
            const MatchedTaps taps = matched_taps(c, n);
            EXPECT_EQ(taps.shift, moments.shift);
            EXPECT_NEAR(1 / (taps.one_tap_exponent + 2), moments.deficit, 1e-12 * moments.deficit);

            const double m = taps.two_tap_exponent;
            const double half = std::sin(taps.two_tap_angle / 2);
            const double chord = 2 * half * half;
            EXPECT_NEAR(1 / (m + 2) + (m + 1) / (m + 2) * chord, moments.deficit,
                        1e-8 * moments.deficit);
            EXPECT_NEAR(m / (m + 3) * chord * (2 - chord), moments.across - moments.in_plane,
                        2e-9 * moments.across);
            // What a material's maps must cover
            EXPECT_GE(taps.one_tap_exponent, (n + 1) * (1 - 1e-8));
            EXPECT_GE(taps.two_tap_exponent, (n + 1) * (1 - 1e-8));
            EXPECT_LE(taps.one_tap_exponent, 1.4 * n + 3);
            EXPECT_LE(taps.two_tap_exponent, 2.34 * n + 8);
        }
}

const auto TABLE = make_clipped_table();

float nearest_half(float value) {
    if (value == 0) return 0;
    const float step = std::ldexp(1.0f, std::max(std::ilogb(value), -14) - 10);
    return std::nearbyint(value / step) * step;
}

// What a shader gets from a table of halves.
ClippedTaps read_table(double cosine, double exponent) {
    const ClippedTablePoint at = clipped_table_point(float(cosine), float(exponent));
    const double x =
        std::clamp(double(at.u) * CLIPPED_TABLE_WIDTH - 0.5, 0.0, CLIPPED_TABLE_WIDTH - 1.0);
    const double y =
        std::clamp(double(at.v) * CLIPPED_TABLE_HEIGHT - 0.5, 0.0, CLIPPED_TABLE_HEIGHT - 1.0);
    const uint column = std::min(uint(x), CLIPPED_TABLE_WIDTH - 2);
    const uint row = std::min(uint(y), CLIPPED_TABLE_HEIGHT - 2);
    float texel[4] = {};
    for (uint i = 0; i < 4; ++i) {
        const auto stored = [&](uint below, uint right) {
            const uint index = (row + below) * CLIPPED_TABLE_WIDTH + column + right;
            return nearest_half(TABLE[index][i]);
        };
        texel[i] = float(std::lerp(std::lerp(stored(0, 0), stored(0, 1), x - column),
                                   std::lerp(stored(1, 0), stored(1, 1), x - column), y - row));
    }
    return clipped_taps(texel[0], texel[1], texel[2], texel[3], float(cosine), float(exponent));
}

// Angle of axis + sideways N x R from R towards N, and from the plane of N and R.
double shift_of(const ClippedTaps& taps, double cosine) {
    return std::atan2(sine_of(cosine), cosine + double(taps.along_mirror));
}
double angle_of(const ClippedTaps& taps, double cosine) {
    const double k = taps.along_mirror;
    return std::atan(taps.across * sine_of(cosine) / std::sqrt(1 + k * (2 * cosine + k)));
}

TEST(ClippedTable, LiesInTheRangeThatHalvesHoldWell) {
    EXPECT_EQ(TABLE.size(), CLIPPED_TABLE_WIDTH * CLIPPED_TABLE_HEIGHT);
    for (const auto& texel : TABLE)
        for (float value : texel) {
            EXPECT_GE(value, -1e-6f);
            EXPECT_LE(value, 1.0f);
        }
}

TEST(ClippedTable, ReadsBetweenItsTexelsAsComputed) {
    // Linear interpolation errs by an eighth of the second difference. The table's largest, across
    // and down together, make 3.6e-3 for the shift, 1.9e-3 and 3.9e-3 for the variances, and 1e-2
    // for the offset, that only at the pole, where the offset counts times a sine below a third.
    // Halves add 2^-12.
    for (double n : {0.0,  0.01, 0.1,  0.3,   0.7,   1.0,   1.7,    3.0,    4.8, 8.0, 13.0,
                     22.0, 40.0, 64.0, 130.0, 256.0, 700.0, 1024.0, 5000.0, 3e4, 1e5, 1e6})
        for (double c : cosines(n, 97)) {
            const MatchedTaps exact = matched_taps(float(c), n);
            const ClippedTaps taps = read_table(c, n);
            const double width = 1 / std::sqrt(n + 1);
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            ASSERT_NEAR(shift_of(taps, float(c)), exact.shift, 4e-3 * width);
            ASSERT_NEAR(taps.one_tap_variance * exact.one_tap_exponent, 1, 2.2e-3);
            ASSERT_NEAR(taps.two_tap_variance * exact.two_tap_exponent, 1, 4.2e-3);
            ASSERT_NEAR(angle_of(taps, float(c)), exact.two_tap_angle, 4e-3 * width);
        }
}

TEST(ClippedTable, TakesAnyCosineAndExponent) {
    for (double n : EXPONENTS)
        for (double c : {-1e-6, 0.0, 1e-30, 1e-7, 0.999999, 1.0, 1.0 + 1e-6}) {
            const ClippedTaps taps = read_table(c, n);
            for (float value :
                 {taps.along_mirror, taps.one_tap_variance, taps.two_tap_variance, taps.across})
                EXPECT_TRUE(std::isfinite(value) && value >= 0)
                    << value << " at cosine " << c << ", exponent " << n;
            EXPECT_GT(taps.one_tap_variance, 0);
            EXPECT_GT(taps.two_tap_variance, 0);
        }
}

} // namespace
} // namespace lobelia
