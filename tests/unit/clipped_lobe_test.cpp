#include "clipped_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "clipped_lobe_cases.h"
#include "support/oracle.h"
#include "support/quadrature.h"

namespace lobelia {
namespace {

using oracle::Direction;

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

// A Phong lobe's mean and mean squares, by Funk-Hecke: (m + 1) / (m + 2) of its axis d, and
// (1 + m d d) / (m + 3).
struct Mixture {
    Direction mean{};
    double across = 0;   // mean square along y
    double in_plane = 0; // along `side`

    void add(double share, Direction d, double m, Direction side) {
        const double length = share * (m + 1) / (m + 2);
        mean = {mean.x + length * d.x, mean.y + length * d.y, mean.z + length * d.z};
        const double along_side = dot(d, side);
        across += share * (1 + m * d.y * d.y) / (m + 3);
        in_plane += share * (1 + m * along_side * along_side) / (m + 3);
    }
};

Direction unit(double x, double y, double z) {
    const double length = std::hypot(x, y, z);
    return {x / length, y / length, z / length};
}

TEST(HorizonTaps, HaveTheClippedMomentsTogetherWithTheirPair) {
    for (double n : EXPONENTS)
        for (double c : cosines(n, 16)) {
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            const HorizonPair pair = horizon_pair(c, n);
            EXPECT_GE(pair.weight, 0);
            EXPECT_LT(pair.weight, 0.5);
            EXPECT_GE(pair.exponent, (n + 1) * (1 - 1e-8));
            EXPECT_LE(pair.exponent, 1.34 * n + 8);
            if (c * std::sqrt(n + 1) > 5.3 * sine_of(c)) {
                EXPECT_EQ(pair.weight, 0);
            }

            // R = +z, N x R = -y, the tangent from R towards N = +x
            const double sine = sine_of(c);
            const Direction axis{std::sin(pair.shift), 0, std::cos(pair.shift)};
            const Direction side{axis.z, 0, -axis.x};
            Mixture all;
            for (double sign : {-1.0, 1.0}) {
                const double out = sign * std::sin(pair.angle), in = std::cos(pair.angle);
                all.add((1 + pair.weight) / 2, {in * axis.x, out, in * axis.z}, pair.exponent,
                        side);
            }
            const HorizonTaps taps = horizon_taps(float(c), float(n));
            const double x = taps.along_normal * sine,
                         z = taps.along_mirror + taps.along_normal * c;
            const double middle = double(HORIZON_MIDDLE_SHARE) * pair.weight;
            const double outer = (pair.weight - middle) / 2;
            if (pair.weight > 0) {
                all.add(-middle, unit(x, 0, z), 1 / double(taps.middle_variance), side);
                for (double sign : {-1.0, 1.0})
                    all.add(-outer, unit(x, sign * taps.side * sine, z),
                            1 / double(taps.side_variance), side);
            }

            const ClippedMoments moments = clipped_moments(c, n);
            const double variance = moments.across;
            EXPECT_NEAR(std::atan2(all.mean.x, all.mean.z), moments.shift,
                        1e-8 * std::sqrt(variance));
            EXPECT_NEAR(1 - std::hypot(all.mean.x, all.mean.z), moments.deficit, 1e-8 * variance);
            const double turn = pair.shift - moments.shift;
            const double in_plane =
                std::cos(turn) * std::cos(turn) * moments.in_plane -
                2 * std::sin(turn) * std::cos(turn) * moments.tilt +
                std::sin(turn) * std::sin(turn) * (1 - moments.in_plane - moments.across);
            EXPECT_NEAR(all.across - all.in_plane, moments.across - in_plane, 1e-8 * variance);
        }
}

TEST(HorizonTaps, StandAlongTheHorizon) {
    // With the mirror direction on the horizon, 0.04 lobe widths below it and one beside.
    for (double n : {0.0, 1.0, 16.0, 1024.0, 1e6}) {
        const HorizonTaps taps = horizon_taps(0.0f, float(n));
        const double width = 1 / std::sqrt(n + 1);
        EXPECT_NEAR(taps.along_normal / taps.along_mirror, -0.0374 * width, 1e-6 * width);
        EXPECT_NEAR(taps.side / taps.along_mirror, width, 1e-6 * width);
    }
}

} // namespace
} // namespace lobelia
