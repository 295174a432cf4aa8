#include <cfloat>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/lobes.h"
#include "support/quadrature.h"
#include "unit_vectors.h"

namespace lobelia {
namespace {

// Most of these errors are the last place of a 32-bit float, a few times over.
constexpr double ROUNDING = 1e-6;

// Integral over the directions nearer to the axis than `edge`, a chord, of a function of the chord.
// On the sphere, solid angle is 2 pi times the chord.
template <class Function>
double integrate_cap(double edge, Function f) {
    const auto scaled = [&](double x, double) { return f(edge * x); };
    return 2 * std::numbers::pi * edge * oracle::tanh_sinh(scaled, 1.0 / 64);
}

class EveryLobe : public testing::TestWithParam<Lobe> {
protected:
    static double density(double chord) { return lobe_density(GetParam(), float(chord)); }
};

TEST_P(EveryLobe, IntegratesToOne) {
    EXPECT_NEAR(integrate_cap(1.0, density), 1.0, ROUNDING);
}

TEST_P(EveryLobe, GivesNothingBehind) {
    for (double chord : {1.0, 1.0 + 1e-6, 1.5, 2.0}) EXPECT_EQ(density(chord), 0.0) << chord;
}

TEST_P(EveryLobe, IsLargestOnTheAxisAndFallsFromIt) {
    EXPECT_EQ(density(0), double(lobe_peak(GetParam())));
    for (double chord = 1e-9; chord < 0.9; chord *= 1.5)
        EXPECT_LE(density(1.5 * chord), density(chord) * (1 + ROUNDING)) << chord;
}

TEST_P(EveryLobe, SamplesFollowItsDensity) {
    // The density's integral over the cap inside a sampled angle is the number that was sampled.
    for (float u : {1e-6f, 0.01f, 0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 0.999f}) {
        const double edge = lobe_sample_chord(GetParam(), u);
        EXPECT_NEAR(integrate_cap(edge, density), u, ROUNDING) << "chord " << edge;
    }
}

TEST_P(EveryLobe, SamplesBeginOnTheAxisAndStayInFront) {
    EXPECT_EQ(lobe_sample_chord(GetParam(), 0.0f), 0.0f);
    const float last = std::nextafter(1.0f, 0.0f);
    EXPECT_LE(lobe_sample_chord(GetParam(), last), 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Lobe, EveryLobe, testing::ValuesIn(test::all_lobes()));

TEST(EveryLobeTable, HasEachKind) {
    for (uint kind = 0; kind < LOBE_COUNT; ++kind) {
        int examples = 0;
        for (const Lobe& lobe : test::all_lobes()) examples += lobe.kind == kind;
        EXPECT_GT(examples, 0) << "kind " << kind;
    }
}

TEST(Lobe, HasTheMeanCosineOfItsExponent) {
    // (n + 1) / (n + 2), held by its distance from 1, which a sharp lobe's cosine would hide.
    for (const Lobe& lobe : test::all_lobes()) {
        const double n = lobe.kind == LOBE_PHONG ? double(lobe.exponent) : 1.0;
        const auto moment = [&](double t) { return t * lobe_density(lobe, float(t)); };
        EXPECT_NEAR(integrate_cap(1.0, moment) * (n + 2), 1.0, ROUNDING)
            << testing::PrintToString(lobe);
    }
}

TEST(Lobe, PhongOfExponentOneIsLambert) {
    for (float chord = 0.0f; chord < 1.25f; chord += 1.0f / 64) {
        const float lambertian = lobe_density(lambert(), chord);
        EXPECT_NEAR(lobe_density(phong(1.0f), chord), lambertian, ROUNDING) << chord;
    }
}

TEST(LogarithmAndExponential, KeepTheirLastPlaces) {
    for (float t = 1e-10f; t < 1.0f; t *= 1.003f) {
        const double exact = std::log1p(-double(t)) / std::numbers::ln2;
        ASSERT_NEAR(log2_one_minus(t) / exact, 1.0, 2.5e-7) << t;
    }
    for (float x = 1e-10f; x < 30.0f; x *= 1.003f) {
        const double exact = -std::expm1(-std::numbers::ln2 * double(x));
        ASSERT_NEAR(one_minus_exp2(x) / exact, 1.0, 2e-7) << x;
    }
    EXPECT_EQ(log2_one_minus(0.0f), 0.0f);
    EXPECT_EQ(one_minus_exp2(0.0f), 0.0f);
}

TEST(ChordPower, IsThePowerOfTheCosine) {
    for (float n : {0.0f, 1e-30f, 1e-6f, 0.5f, 1.0f, 4.8f, 64.0f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        for (float t = 1e-12f; t < 1.0f; t *= 1.03f) {
            const double log2_power = n * std::log1p(-double(t)) / std::numbers::ln2;
            const double power = std::exp2(log2_power);
            // The documented bound; below the normal numbers, their spacing.
            const double bound = 1e-7 * (4 + 6 * std::abs(log2_power)) * power + FLT_MIN;
            ASSERT_NEAR(chord_power(t, n), power, bound) << "exponent " << n << ", chord " << t;
        }
    }
}

TEST(ChordPower, IsDefinedAtBothEnds) {
    const float last = std::nextafter(1.0f, 0.0f);
    for (float n : {0.0f, 1e-30f, 1.0f, 1e6f}) {
        EXPECT_EQ(chord_power(0.0f, n), 1.0f) << n;
        EXPECT_EQ(chord_power(1.0f, n), 0.0f) << n;
        EXPECT_EQ(chord_power(2.0f, n), 0.0f) << n;
        EXPECT_TRUE(std::isfinite(chord_power(last, n))) << n;
    }
    EXPECT_EQ(chord_power(last, 0.0f), 1.0f);
}

TEST(PhongBrdf, ReflectsItsColoursAtNormalIncidence) {
    // There the mirror direction is the normal: the reflected share is diffuse + specular.
    for (float n : {0.0f, 1.0f, 4.8f, 64.0f, 1e4f, 1e6f}) {
        const auto reflected = [n](double t) {
            return phong_brdf(0.3f, 0.6f, n, float(t)) * (1 - t);
        };
        EXPECT_NEAR(integrate_cap(1.0, reflected), 0.9, ROUNDING) << "exponent " << n;
    }
}

TEST(PhongBrdf, IsReciprocal) {
    // For two directions a and b, each mirrored at the normal: R(a).b = R(b).a.
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const vec3 normal = random_direction(random);
        vec3 in = random_direction(random);
        vec3 out =
            i % 2 ? random_direction(random) : normalize(reflect(-in, normal) + 0.1f * normal);
        if (dot(in, normal) < 0) in = -in;
        if (dot(out, normal) < 0) out = -out;
        const float there = half_square_distance(reflect(-out, normal), in);
        const float back = half_square_distance(reflect(-in, normal), out);
        for (float n : {1.0f, 2.0f, 16.0f, 1e4f}) { // below 1 the slope at the rim is unbounded
            // A rounding e of the vectors moves the chord t by e sqrt(2t), and (1-t)^n by at most
            // e sqrt(n/e) of its peak.
            const double peak = 0.3 / std::numbers::pi + 0.6 * (n + 2) / (2 * std::numbers::pi);
            EXPECT_NEAR(phong_brdf(0.3f, 0.6f, n, there), phong_brdf(0.3f, 0.6f, n, back),
                        peak * 4e-7 * (2 + std::sqrt(n)))
                << "exponent " << n << ", chord " << there;
        }
    }
}

} // namespace
} // namespace lobelia
