// Angles between directions and trigonometry that holds on every device. Vulkan allows sin() and
// cos() an absolute error of 2^-11 and atan() one of 4096 units in the last place: more than a
// texel of a large panorama. These stay below 4e-7. For C++ and GLSL alike.
#ifndef LOBELIA_DIRECTION_GLSL
#define LOBELIA_DIRECTION_GLSL

#include "lobelia/language.glsl"

// The chord of two unit vectors (see lobelia/lobe.glsl): 1 - dot(a, b), without its cancellation.
// Lengths that are off by rounding change it in second order only.
SHARED float half_square_distance(vec3 a, vec3 b) {
    vec3 difference = a - b;
    return 0.5f * dot(difference, difference);
}

// sin(2 pi x) for x in [-1/2, 1/2].
SHARED float sin_turns(float x) {
    float folded = abs(x) > 0.25f ? (x > 0.0f ? 0.5f : -0.5f) - x : x;
    float angle = 2.0f * PI * folded;
    float q = angle * angle;
    return angle * (1.0f - q / 6.0f * (1.0f - q / 20.0f * (1.0f - q / 42.0f * (1.0f - q / 72.0f *
           (1.0f - q / 110.0f)))));
}

// cos(2 pi x) for x in [-1/2, 1/2].
SHARED float cos_turns(float x) { return sin_turns(0.25f - abs(x)); }

// atan(x) for x in [-1, 1]: the series at half the angle, whose tangent is at most 0.42.
SHARED float atan_series(float x) {
    float half_tangent = x / (1.0f + sqrt(1.0f + x * x));
    float q = half_tangent * half_tangent;
    return 2.0f * half_tangent * (1.0f - q * (1.0f / 3.0f - q * (1.0f / 5.0f - q * (1.0f / 7.0f -
           q * (1.0f / 9.0f - q * (1.0f / 11.0f - q * (1.0f / 13.0f - q * (1.0f / 15.0f))))))));
}

// Angle of the point (x, y) from the +x axis, in (-pi, pi]; 0 at the origin.
SHARED float angle_of(float y, float x) {
    float longer = max(abs(x), abs(y));
    if (longer == 0.0f) return 0.0f;
    float angle = atan_series(min(abs(x), abs(y)) / longer);
    if (abs(y) > abs(x)) angle = 0.5f * PI - angle;
    if (x < 0.0f) angle = PI - angle;
    return y < 0.0f ? -angle : angle;
}

#endif
