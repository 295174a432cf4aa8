// Suns: small sources that are too bright for a blurred map, kept beside it and summed exactly.
#ifndef LOBELIA_SUNS_GLSL
#define LOBELIA_SUNS_GLSL

#include "lobelia/direction.glsl"
#include "lobelia/lobe.glsl"

const uint MOST_SUNS = 8u;

struct Sun {
    vec4 direction; // unit vector; w: mean chord of its light from there, its extent
    vec4 energy;    // R G B of radiance times solid angle, beyond what stays in the map
};

// The prefilter's findings, beside its maps: radiance = map / scale + what the suns give. A CPU device
// sums no more of them than there are if the loop counts down, since one that can be seen to end at
// MOST_SUNS is unrolled, and asks at its end, since it goes through what follows a break.
struct PrefilterState {
    float threshold; // luminance above which a texel near a sun is cut
    float scale;     // a power of two
    uint sun_count;
    float ladder_lowest; // exponent of the ladder's first rung; 0 where there is no ladder
    Sun suns[MOST_SUNS];
    vec4 seeds[MOST_SUNS]; // direction around which a sun's texels lie
};

// The exponent of a lobe widened by a source of that extent: variances add.
SHARED float widened_exponent(float exponent, float extent) {
    return exponent / (1.0f + exponent * extent);
}

// What one sun adds to P_n about `axis`.
SHARED vec3 sun_average(Sun sun, vec3 axis, float exponent) {
    float n = widened_exponent(exponent, sun.direction.w);
    float chord = half_square_distance(vec3(sun.direction.x, sun.direction.y, sun.direction.z), axis);
    float density = (n + 1.0f) / (2.0f * PI) * chord_power(chord, n);
    return density * vec3(sun.energy.x, sun.energy.y, sun.energy.z);
}

// The specular lobe towards a sun, per steradian, before the cosine to the normal.
SHARED float clipped_sun_lobe(Sun sun, vec3 mirror, float exponent) {
    float n = widened_exponent(exponent, sun.direction.w);
    float chord = half_square_distance(vec3(sun.direction.x, sun.direction.y, sun.direction.z), mirror);
    return (n + 2.0f) / (2.0f * PI) * chord_power(chord, n);
}

#endif
