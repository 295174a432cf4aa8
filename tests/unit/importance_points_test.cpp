#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/lobes.h"
#include "unit_vectors.h"

// Which directions importance sampling looks in, and how wide each look is.
namespace lobelia {
namespace {

std::vector<vec3> axes() {
    std::vector<vec3> axes;
    for (int i = 0; i < 3; ++i)
        for (float sign : {1.0f, -1.0f}) {
            vec3 axis(0.0f);
            axis[i] = sign;
            axes.push_back(axis);
        }
    axes.push_back(vec3(1.0f, 0.0f, -0.0f));
    axes.push_back(normalize(vec3(1e-4f, -1e-5f, -1.0f)));
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) axes.push_back(random_direction(random));
    return axes;
}

TEST(SamplePoint, FillsTheMiddlesOfTheStrataAndEveryTurnOnce) {
    for (uint count : {1u, 2u, 64u, 4096u}) {
        std::vector<float> turns;
        for (uint i = 0; i < count; ++i) {
            const SamplePoint point = sample_point(i, count);
            ASSERT_EQ(point.share, (float(i) + 0.5f) / float(count));
            turns.push_back(point.turn);
        }
        std::sort(turns.begin(), turns.end());
        for (uint i = 0; i < count; ++i)
            ASSERT_EQ(turns[i], float(i) / float(count) - 0.5f) << "of " << count;
    }
}

TEST(SamplePoint, StaysInsideTheLobeForAnyNumberOfPoints) {
    for (uint count : {3u, 1000u, 65535u})
        for (uint i = 0; i < count; ++i) {
            const SamplePoint point = sample_point(i, count);
            ASSERT_TRUE(point.share > 0.0f && point.share < 1.0f) << i << " of " << count;
            ASSERT_TRUE(point.turn >= -0.5f && point.turn < 0.5f) << i << " of " << count;
        }
}

TEST(LobeFrame, StandsUprightOnEveryAxis) {
    for (const vec3& axis : axes()) {
        const LobeFrame frame = lobe_frame(axis);
        EXPECT_NEAR(dot(frame.right, frame.right), 1.0, LAST_PLACES) << axis.z;
        EXPECT_NEAR(dot(frame.up, frame.up), 1.0, LAST_PLACES) << axis.z;
        EXPECT_NEAR(dot(frame.right, frame.up), 0.0, LAST_PLACES) << axis.z;
        EXPECT_NEAR(dot(frame.right, axis), 0.0, LAST_PLACES) << axis.z;
        EXPECT_NEAR(dot(frame.up, axis), 0.0, LAST_PLACES) << axis.z;
    }
}

TEST(DirectionAbout, LiesAtItsChordAndGoesRound) {
    for (const vec3& axis : axes()) {
        const LobeFrame frame = lobe_frame(axis);
        for (float chord : {0.0f, 1e-6f, 1e-3f, 0.5f, 1.0f, 2.0f})
            for (float turn : {-0.5f, -0.2f, 0.0f, 0.25f, 0.4f}) {
                const vec3 direction = direction_about(frame, chord, turn);
                EXPECT_NEAR(dot(direction, direction), 1.0, 2 * LAST_PLACES);
                // The vectors' rounding moves the chord by itself times the distance.
                EXPECT_NEAR(half_square_distance(axis, direction), chord,
                            LAST_PLACES * (std::sqrt(2 * chord) + chord + 1e-6f));
                const float across = std::sqrt(chord * (2 - chord));
                EXPECT_NEAR(dot(direction, frame.right),
                            across * std::cos(2 * 3.14159265358979 * double(turn)),
                            2 * LAST_PLACES);
            }
    }
}

TEST(SampleLevel, HasTexelsAsLargeAsTheSample) {
    // On a face of 512 a texel's true solid angle differs by 1e-5 from its density's.
    constexpr uint SIZE = 512;
    for (uint face = 0; face < CUBE_FACES; ++face)
        for (uint x : {0u, 100u, 255u, 511u})
            for (uint y : {3u, 256u, 400u}) {
                const vec3 direction = normalize(
                    cube_direction(face, cube_texel_centre(x, SIZE), cube_texel_centre(y, SIZE)));
                const float texel = cube_texel_solid_angle(x, y, SIZE);
                for (float level : {0.0f, 1.0f, 2.5f, 8.0f}) {
                    const float sample = texel * std::exp2(2 * level);
                    EXPECT_NEAR(sample_level(1.0f / (64 * sample), 64, direction, float(SIZE)),
                                level, 1e-4);
                }
                EXPECT_EQ(sample_level(8.0f / texel, 1, direction, float(SIZE)), 0.0f);
            }
}

TEST(LobeSample, HasTheMeanCosineOfItsLobe) {
    // The shares' midpoint rule: its error is at most the largest change within a stratum, over N;
    // the cosine falls by at most 1 in all.
    constexpr uint COUNT = 4096;
    const vec3 axis = normalize(vec3(1, -2, 3));
    for (const Lobe& lobe : test::all_lobes()) {
        const double n = lobe.kind == LOBE_PHONG ? double(lobe.exponent) : 1.0;
        double chord = 0;
        for (uint i = 0; i < COUNT; ++i) {
            const LobeSample look = lobe_sample(lobe, lobe_frame(axis), i, COUNT, 256.0f);
            chord += half_square_distance(axis, look.direction) / double(COUNT);
            ASSERT_GE(look.level, 0.0f);
        }
        EXPECT_NEAR(chord, 1 / (n + 2), 1.0 / COUNT) << testing::PrintToString(lobe);
    }
}

} // namespace
} // namespace lobelia
