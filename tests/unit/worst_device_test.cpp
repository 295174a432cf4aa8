#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/shared.h"

// The shared text once more, on the worst device that Vulkan allows ("Precision of GLSL.std.450
// Instructions"): its log2() is off by 2^-21 in [0.5, 2] and by 3 units in the last place
// elsewhere, its exp2(x) by 3 + 2 |x| units.
namespace lobelia::worst_device {

inline float error_sign = 1.0f; // which way log2() errs
inline float exp2_sign = 1.0f;

constexpr float LAST_PLACE = 0x1p-23f;

inline float log2(float x) {
    const float exact = std::log2(x);
    const bool absolute = x >= 0.5f && x <= 2.0f;
    return exact + error_sign * (absolute ? 0x1p-21f : 3 * LAST_PLACE * std::abs(exact));
}

inline float exp2(float x) {
    return std::exp2(x) * (1 + exp2_sign * (3 + 2 * std::abs(x)) * LAST_PLACE);
}

#undef LOBELIA_ALBEDO_GLSL
#undef LOBELIA_LANGUAGE_GLSL
#undef LOBELIA_LOBE_GLSL
#define SHARED inline
#include "lobelia/albedo.glsl"
#undef SHARED

} // namespace lobelia::worst_device

namespace lobelia {
namespace {

class WorstDevice : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        worst_device::error_sign = GetParam() & 1 ? 1.0f : -1.0f;
        worst_device::exp2_sign = GetParam() & 2 ? 1.0f : -1.0f;
    }
};

TEST_P(WorstDevice, KeepsThePowerWithinItsBound) {
    for (float n : {1e-6f, 0.5f, 1.0f, 4.8f, 10.0f, 64.0f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        for (float t = 1e-12f; t < 1.0f; t *= 1.03f) {
            const double log2_power = n * std::log1p(-double(t)) / std::numbers::ln2;
            if (log2_power < -100) break;
            const double power = std::exp2(log2_power);
            ASSERT_NEAR(worst_device::chord_power(t, n), power,
                        1e-7 * (4 + 6 * std::abs(log2_power)) * power)
                << "exponent " << n << ", chord " << t;
        }
    }
}

TEST_P(WorstDevice, KeepsTheAlbedo) {
    for (float n : {0.0f, 0.1f, 1.0f, 4.8f, 64.0f, 1e3f, 1e4f, 1e6f})
        for (float c = 0.0f; c <= 1.0f; c += 1.0f / 512)
            ASSERT_NEAR(worst_device::phong_albedo(c, n), phong_albedo(c, n), 1e-6)
                << "cosine " << c << ", exponent " << n;
}

INSTANTIATE_TEST_SUITE_P(BothWays, WorstDevice, testing::Range(0, 4));

} // namespace
} // namespace lobelia
