#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "unit_vectors.h"

namespace lobelia {
namespace {

constexpr double PI_EXACT = std::numbers::pi;

// Vulkan specification, table "Cube map face and coordinate selection": for each layer the axis
// that is major, and the axes, with signs, that become s (rightwards) and t (downwards).
struct Axis {
    int index; // of x, y, z
    double sign;
};
struct SpecifiedFace {
    Axis major, s, t;
};
constexpr std::array<SpecifiedFace, 6> SPECIFICATION{{
    {{0, +1}, {2, -1}, {1, -1}}, // +X: -rz, -ry
    {{0, -1}, {2, +1}, {1, -1}}, // -X: +rz, -ry
    {{1, +1}, {0, +1}, {2, +1}}, // +Y: +rx, +rz
    {{1, -1}, {0, +1}, {2, -1}}, // -Y: +rx, -rz
    {{2, +1}, {0, +1}, {1, -1}}, // +Z: +rx, -ry
    {{2, -1}, {0, -1}, {1, -1}}, // -Z: -rx, -ry
}};

double along(vec3 direction, Axis axis) {
    return axis.sign * double(direction[axis.index]);
}

TEST(CubePoint, FollowsVulkansTable) {
    std::mt19937 random(1);
    for (int i = 0; i < 10000; ++i) {
        const vec3 direction = random_direction(random);
        const CubePoint point = cube_point(direction);
        ASSERT_LT(point.face, 6u);
        const SpecifiedFace& face = SPECIFICATION[point.face];
        const double major = along(direction, face.major);
        for (int axis = 0; axis < 3; ++axis) ASSERT_GE(major, std::abs(double(direction[axis])));
        EXPECT_NEAR(point.u, along(direction, face.s) / major, LAST_PLACES);
        EXPECT_NEAR(point.v, along(direction, face.t) / major, LAST_PLACES);
    }
}

TEST(CubeDirection, FollowsVulkansTable) {
    for (uint face = 0; face < CUBE_FACES; ++face) {
        const SpecifiedFace& specified = SPECIFICATION[face];
        const vec3 direction = cube_direction(face, 0.25f, -0.5f);
        EXPECT_EQ(along(direction, specified.major), 1.0) << "face " << face;
        EXPECT_EQ(along(direction, specified.s), 0.25) << "face " << face;
        EXPECT_EQ(along(direction, specified.t), -0.5) << "face " << face;
    }
}

TEST(CubePoint, FindsEachTexelCentre) {
    for (uint size : {1u, 2u, 3u, 64u}) {
        for (uint face = 0; face < CUBE_FACES; ++face)
            for (uint y = 0; y < size; ++y)
                for (uint x = 0; x < size; ++x) {
                    const float u = cube_texel_centre(x, size);
                    const float v = cube_texel_centre(y, size);
                    const CubePoint point = cube_point(normalize(cube_direction(face, u, v)));
                    ASSERT_EQ(point.face, face) << "texel " << x << ' ' << y << " of " << size;
                    ASSERT_NEAR(point.u, u, LAST_PLACES);
                    ASSERT_NEAR(point.v, v, LAST_PLACES);
                }
    }
}

TEST(CubePoint, GivesEdgesToZThenY) {
    for (float x : {-1.0f, 1.0f})
        for (float y : {-1.0f, 1.0f}) {
            EXPECT_EQ(cube_point(vec3(x, y, 1)).face, 4u);
            EXPECT_EQ(cube_point(vec3(x, y, -1)).face, 5u);
            EXPECT_EQ(cube_point(vec3(x, 0.5f, y)).face, y > 0 ? 4u : 5u);
            EXPECT_EQ(cube_point(vec3(x, y, 0.5f)).face, y > 0 ? 2u : 3u);
        }
}

TEST(CubeTexelCentre, IsSymmetricToTheBit) {
    for (uint size : {1u, 3u, 7u, 100u, 2048u})
        for (uint i = 0; i < size; ++i)
            EXPECT_EQ(cube_texel_centre(i, size), -cube_texel_centre(size - 1 - i, size));
    EXPECT_EQ(cube_texel_centre(0, 2), -0.5f);
    EXPECT_EQ(cube_texel_centre(3, 4), 0.75f);
}

// Solid angle of the rectangle from the face's centre to (u, v).
double corner_solid_angle(double u, double v) {
    return std::atan2(u * v, std::sqrt(1 + u * u + v * v));
}

double exact_solid_angle(uint x, uint y, uint size) {
    const double left = 2.0 * x / size - 1;
    const double top = 2.0 * y / size - 1;
    const double right = left + 2.0 / size;
    const double bottom = top + 2.0 / size;
    return corner_solid_angle(right, bottom) - corner_solid_angle(left, bottom) -
           corner_solid_angle(right, top) + corner_solid_angle(left, top);
}

TEST(CubeTexelSolidAngle, HoldsAtEverySize) {
    std::mt19937 random(1);
    for (uint size : {1u, 2u, 3u, 4u, 16u, 255u, 1024u, 4096u}) {
        std::uniform_int_distribution<uint> texel(0, size - 1);
        for (uint i = 0; i < 2000; ++i) {
            const uint x = i < 4 ? (i & 1) * (size - 1) : texel(random); // the corners first
            const uint y = i < 4 ? (i >> 1) * (size - 1) : texel(random);
            const double exact = exact_solid_angle(x, y, size);
            ASSERT_NEAR(cube_texel_solid_angle(x, y, size), exact, 1e-6 * exact)
                << "texel " << x << ' ' << y << " of " << size;
        }
    }
}

TEST(CubeTexelSolidAngle, AddsUpToTheSphere) {
    for (uint size : {1u, 2u, 3u, 5u, 8u, 64u, 127u, 512u}) {
        double sum = 0;
        for (uint y = 0; y < size; ++y)
            for (uint x = 0; x < size; ++x) sum += 6.0 * cube_texel_solid_angle(x, y, size);
        EXPECT_NEAR(sum, 4 * PI_EXACT, 4 * PI_EXACT * 1e-6) << "size " << size;
    }
}

void expect_direction(vec3 actual, double x, double y, double z) {
    EXPECT_NEAR(actual.x, x, LAST_PLACES);
    EXPECT_NEAR(actual.y, y, LAST_PLACES);
    EXPECT_NEAR(actual.z, z, LAST_PLACES);
}

TEST(Panorama, HasItsCentreAtPlusZ) {
    expect_direction(panorama_direction(0.5f, 0.5f), 0, 0, 1);
    expect_direction(panorama_direction(0.25f, 0.5f), 1, 0, 0);
    expect_direction(panorama_direction(0.75f, 0.5f), -1, 0, 0);
    expect_direction(panorama_direction(0.0f, 0.5f), 0, 0, -1);
    expect_direction(panorama_direction(1.0f, 0.5f), 0, 0, -1);
    expect_direction(panorama_direction(0.3f, 0.0f), 0, 1, 0);
    expect_direction(panorama_direction(0.3f, 1.0f), 0, -1, 0);
}

TEST(Panorama, IsAGridOfLongitudesAndLatitudes) {
    for (float v = 0.0f; v <= 1.0f; v += 1.0f / 64)
        for (float u = 0.0f; u <= 1.0f; u += 1.0f / 128) {
            SCOPED_TRACE(testing::Message() << "u " << u << ", v " << v);
            const double longitude = 2 * PI_EXACT * (0.5 - u);
            const double latitude = PI_EXACT * (0.5 - v);
            expect_direction(panorama_direction(u, v), std::sin(longitude) * std::cos(latitude),
                             std::sin(latitude), std::cos(longitude) * std::cos(latitude));
        }
}

TEST(Panorama, FindsThePointOfADirection) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const vec3 direction = 3.0f * random_direction(random);
        const PanoramaPoint point = panorama_point(direction);
        const double radius = std::hypot(double(direction.x), double(direction.z));
        const double longitude = std::atan2(double(direction.x), double(direction.z));
        EXPECT_NEAR(point.u, 0.5 - longitude / (2 * PI_EXACT), 2e-7);
        EXPECT_NEAR(point.v, 0.5 - std::atan2(double(direction.y), radius) / PI_EXACT, 2e-7);
    }
    EXPECT_EQ(panorama_point(vec3(0, 2, 0)).u, 0.5f);
    EXPECT_EQ(panorama_point(vec3(0, 2, 0)).v, 0.0f);
    EXPECT_EQ(panorama_point(vec3(0, -2, 0)).v, 1.0f);
}

TEST(Direction, MeasuresSmallAngles) {
    // Where a 32-bit dot product gives 1 or more, the chord still has its digits.
    const vec3 axis = normalize(vec3(1, 2, 3));
    const vec3 across = normalize(vec3(3, 0, -1));
    for (double angle : {1e-4, 1e-3, 1e-2, 0.3}) {
        const vec3 tilted = float(std::cos(angle)) * axis + float(std::sin(angle)) * across;
        const double chord = 1 - std::cos(angle);
        EXPECT_NEAR(half_square_distance(axis, tilted), chord, angle * 2e-7 + 1e-7 * chord);
    }
    EXPECT_EQ(half_square_distance(axis, -axis), 2.0f * dot(axis, axis));
}

TEST(Direction, HasTrigonometryOfItsOwn) {
    for (int i = -4096; i <= 4096; ++i) {
        const float turns = float(i) / 8192.0f;
        EXPECT_NEAR(sin_turns(turns), std::sin(2 * PI_EXACT * turns), 2e-7) << turns;
        EXPECT_NEAR(cos_turns(turns), std::cos(2 * PI_EXACT * turns), 2e-7) << turns;
        const float y = float(std::sin(2 * PI_EXACT * turns));
        const float x = float(std::cos(2 * PI_EXACT * turns));
        EXPECT_NEAR(angle_of(y, x), std::atan2(double(y), double(x)), LAST_PLACES) << turns;
    }
    for (float x = 1e-6f; x <= 1.0f; x *= 1.003f)
        EXPECT_NEAR(atan_series(x) / std::atan(double(x)), 1.0, 2.5e-7) << x;
    EXPECT_EQ(angle_of(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(angle_of(0.0f, 1.0f), 0.0f);
}

} // namespace
} // namespace lobelia
