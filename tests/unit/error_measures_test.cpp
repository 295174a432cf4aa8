#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <lobelia/host/error_measures.h>

// What measurements say of errors, against values computed by hand.
namespace lobelia::host {
namespace {

TEST(ErrorMeasuresTest, AreTheHandComputedOnes) {
    const std::vector<float> exact{1.0f, 1.0f, 2.0f, 0.0f};
    const std::vector<float> values{1.125f, 1.0f, 2.0f, 0.0009765625f};
    // The mean of `exact` is 1, so black is weighed by 1e-3.
    const double first = 0.125 / 1.001, last = 0.0009765625 / 0.001;
    const ErrorMeasures error = measure_error(values, exact);
    EXPECT_DOUBLE_EQ(error.rms, std::sqrt((first * first + last * last) / 4));
    EXPECT_DOUBLE_EQ(error.max, last);
    EXPECT_DOUBLE_EQ(error.p999, last);
    EXPECT_DOUBLE_EQ(error.image_rms, std::sqrt((0.125 * 0.125 + 0.0009765625 * 0.0009765625) / 6));
    EXPECT_DOUBLE_EQ(error.mean_ratio, 4.1259765625 / 4);
}

TEST(ErrorMeasuresTest, LeaveOneInAThousandOutOfThePercentile) {
    const std::vector<float> exact(1000, 1.0f);
    std::vector<float> values = exact;
    values[17] = 1.5f;
    values[400] = 0.75f;
    const ErrorMeasures error = measure_error(values, exact);
    EXPECT_DOUBLE_EQ(error.max, 0.5 / 1.001);
    EXPECT_DOUBLE_EQ(error.p999, 0.25 / 1.001);
}

TEST(ErrorMeasuresTest, AreNoneOfWhatIsExact) {
    for (const std::vector<float>& exact : {std::vector{0.0f, 0.0f}, {3.0f, 1e9f}}) {
        const ErrorMeasures error = measure_error(exact, exact);
        EXPECT_EQ(error.rms, 0.0);
        EXPECT_EQ(error.max, 0.0);
        EXPECT_EQ(error.image_rms, 0.0);
        EXPECT_EQ(error.mean_ratio, 1.0);
    }
}

TEST(ErrorMeasuresTest, AreInfiniteOfLightWhereAllIsBlack) {
    const std::vector<float> exact{0.0f, 0.0f}, values{0.0f, 1.0f};
    const ErrorMeasures error = measure_error(values, exact);
    EXPECT_EQ(error.rms, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error.image_rms, std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace lobelia::host
