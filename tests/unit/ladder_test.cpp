#include <cmath>

#include <gtest/gtest.h>

#include <lobelia/lobe.h>

namespace lobelia::test {
namespace {

// What a ladder gives for a quantity that is `of(variance)` on its rungs.
template <class Of>
double read_ladder(float lowest, float rungs, double variance, Of of) {
    const LadderPlace place = ladder_place(lowest, rungs, float(variance));
    const auto on_rung = [&](float rung) { return of(1 / double(ladder_exponent(lowest, rung))); };
    return (1 - double(place.share)) * on_rung(place.rung) +
           double(place.share) * on_rung(place.rung + 1);
}

TEST(Ladder, HasRungsARootOfTwoApart) {
    for (const float lowest : {1.0f, 2.0f, 65.0f, 1e6f})
        for (float rung = 0; rung < 12; ++rung)
            EXPECT_NEAR(double(ladder_exponent(lowest, rung)),
                        double(lowest) * std::pow(2.0, double(rung) / 2),
                        1e-6 * double(ladder_exponent(lowest, rung)));
}

TEST(Ladder, IsExactForWhatIsLinearInTheVariance) {
    // 32-bit logarithms place a variance within some 1e-6 of the step between two rungs.
    for (const float lowest : {1.0f, 5.8f, 1001.0f})
        for (int i = 0; i <= 100; ++i) {
            const double variance = 1 / (double(lowest) * std::pow(2.0, 0.5 * 4 * i / 100.0));
            EXPECT_NEAR(read_ladder(lowest, 5, variance, [](double v) { return v; }), variance,
                        2e-6 * variance)
                << lowest << " " << i;
        }
}

TEST(Ladder, StaysOnItsEndsBeyondThem) {
    const auto itself = [](double v) { return v; };
    EXPECT_NEAR(read_ladder(16, 5, 1.0 / 3, itself), 1.0 / 16, 1e-7);
    EXPECT_NEAR(read_ladder(16, 5, 1.0 / 1e6, itself), 1.0 / 64, 1e-7);
    EXPECT_NEAR(read_ladder(16, 2, 1.0 / 1e6, itself), 1.0 / (16 * std::sqrt(2.0)), 1e-7);
}

} // namespace
} // namespace lobelia::test
