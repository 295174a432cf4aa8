#include "clipped_lobe_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "clipped_lobe.h"
#include "clipped_lobe_cases.h"

namespace lobelia {
namespace {

const auto TABLE = make_clipped_table();
const auto HORIZON_TABLE = make_horizon_table();

float nearest_half(float value) {
    if (value == 0) return 0;
    const float step = std::ldexp(1.0f, std::max(std::ilogb(value), -14) - 10);
    return std::nearbyint(value / step) * step;
}

// What a shader gets from a table of halves.
ClippedTexel read(const std::vector<ClippedTexel>& table, double cosine, double exponent) {
    const ClippedTablePoint at = clipped_table_point(float(cosine), float(exponent));
    const double x =
        std::clamp(double(at.u) * CLIPPED_TABLE_WIDTH - 0.5, 0.0, CLIPPED_TABLE_WIDTH - 1.0);
    const double y =
        std::clamp(double(at.v) * CLIPPED_TABLE_HEIGHT - 0.5, 0.0, CLIPPED_TABLE_HEIGHT - 1.0);
    const uint column = std::min(uint(x), CLIPPED_TABLE_WIDTH - 2);
    const uint row = std::min(uint(y), CLIPPED_TABLE_HEIGHT - 2);
    ClippedTexel texel{};
    for (uint i = 0; i < 4; ++i) {
        const auto stored = [&](uint below, uint right) {
            const uint index = (row + below) * CLIPPED_TABLE_WIDTH + column + right;
            return nearest_half(table[index][i]);
        };
        texel[i] = float(std::lerp(std::lerp(stored(0, 0), stored(0, 1), x - column),
                                   std::lerp(stored(1, 0), stored(1, 1), x - column), y - row));
    }
    return texel;
}
ClippedTaps taps_of(const ClippedTexel& texel, double cosine, double exponent) {
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
    for (const auto& table : {TABLE, HORIZON_TABLE}) {
        EXPECT_EQ(table.size(), CLIPPED_TABLE_WIDTH * CLIPPED_TABLE_HEIGHT);
        for (const ClippedTexel& texel : table)
            for (float value : texel) {
                EXPECT_GE(value, -1e-6f);
                EXPECT_LE(value, 1.2f);
            }
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
            const ClippedTaps taps = taps_of(read(TABLE, c, n), c, n);
            const double width = 1 / std::sqrt(n + 1);
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            ASSERT_NEAR(shift_of(taps, float(c)), exact.shift, 4e-3 * width);
            ASSERT_NEAR(taps.one_tap_variance * exact.one_tap_exponent, 1, 2.2e-3);
            ASSERT_NEAR(taps.two_tap_variance * exact.two_tap_exponent, 1, 4.2e-3);
            ASSERT_NEAR(angle_of(taps, float(c)), exact.two_tap_angle, 4e-3 * width);
        }
}

TEST(HorizonTable, ReadsBetweenItsTexelsAsComputed) {
    // As above, with an eighth of the largest second differences: 9.4e-3 for the shift, 4.8e-3
    // for the weight, 6.6e-3 for the variance, 1e-2 for the offset.
    for (double n : {0.0,  0.01, 0.1,  0.3,   0.7,   1.0,   1.7,    3.0,    4.8, 8.0, 13.0,
                     22.0, 40.0, 64.0, 130.0, 256.0, 700.0, 1024.0, 5000.0, 3e4, 1e5, 1e6})
        for (double c : cosines(n, 97)) {
            const HorizonPair exact = horizon_pair(float(c), n);
            const ClippedTexel texel = read(HORIZON_TABLE, c, n);
            const ClippedTaps taps = taps_of(texel, c, n);
            const double width = 1 / std::sqrt(n + 1);
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            ASSERT_NEAR(shift_of(taps, float(c)), exact.shift, 9.6e-3 * width);
            ASSERT_NEAR(texel[1], exact.weight, 5e-3);
            ASSERT_NEAR(taps.two_tap_variance * (n + 1), (n + 1) / exact.exponent, 6.8e-3);
            ASSERT_NEAR(angle_of(taps, float(c)), exact.angle, 1.02e-2 * width);
        }
}

TEST(ClippedTable, TakesAnyCosineAndExponent) {
    for (double n : EXPONENTS)
        for (double c : {-1e-6, 0.0, 1e-30, 1e-7, 0.999999, 1.0, 1.0 + 1e-6}) {
            SCOPED_TRACE(testing::Message() << "cosine " << c << ", exponent " << n);
            const ClippedTaps taps = taps_of(read(TABLE, c, n), c, n);
            const ClippedTexel texel = read(HORIZON_TABLE, c, n);
            const ClippedTaps pair = taps_of(texel, c, n);
            const HorizonTaps horizon = horizon_taps(float(c), float(n));
            for (float value : {taps.along_mirror, taps.across, pair.along_mirror, texel[1],
                                pair.across, horizon.along_mirror}) {
                EXPECT_TRUE(std::isfinite(value));
                EXPECT_GE(value, 0);
            }
            for (float value : {taps.one_tap_variance, taps.two_tap_variance, pair.two_tap_variance,
                                horizon.middle_variance, horizon.side_variance}) {
                EXPECT_TRUE(std::isfinite(value));
                EXPECT_GT(value, 0);
            }
            EXPECT_TRUE(std::isfinite(horizon.along_normal));
            // R = N is where the sum would vanish first.
            EXPECT_GT(horizon.along_mirror + horizon.along_normal, 0);
        }
}

} // namespace
} // namespace lobelia
