// Every lobe the library knows, for C++ and GLSL alike. A lobe is the weight a surface gives to
// light by its angle from an axis. To add one: a LOBE_* constant and a case in each function that
// takes a Lobe. The tests run over LOBE_COUNT kinds and need no change but an example of it.
//
// Angles from the axis come as a `chord`: half the squared distance of two unit vectors, which is
// 1 - cos(theta). A 32-bit cosine near 1 has lost the digits that a sharp lobe lives on; the chord
// has them (lobelia/direction.glsl computes it).
#ifndef LOBELIA_LOBE_GLSL
#define LOBELIA_LOBE_GLSL

#include "lobelia/language.glsl"

const uint LOBE_LAMBERT = 0u; // diffuse; axis: the surface normal
const uint LOBE_PHONG = 1u;   // specular; axis: the mirror direction of the view
const uint LOBE_COUNT = 2u;

struct Lobe {
    uint kind;      // LOBE_*
    float exponent; // LOBE_PHONG: at least 0; other kinds ignore it
};

// log2(1 - t) for t in [0, 1), to a few units in the last place. Vulkan allows log2() an absolute
// error of 2^-21 for arguments in [0.5, 2], which an exponent of 1e6 turns into a factor of 1.4, so
// those go through 2 atanh(s) = log((1 + s) / (1 - s)). The terms left out are below 2e-8 of it.
SHARED float log2_one_minus(float t) {
    if (t > 0.5f) return log2(1.0f - t);
    float s = t / (2.0f - t);
    float q = s * s;
    float series =
        1.0f + q * (1.0f / 3.0f + q * (1.0f / 5.0f + q * (1.0f / 7.0f +
        q * (1.0f / 9.0f + q * (1.0f / 11.0f + q * (1.0f / 13.0f))))));
    return -2.885390081777927f * s * series; // 2 log2(e)
}

// 1 - 2^-x for x >= 0, to a few units in the last place where 2^-x is next to 1.
SHARED float one_minus_exp2(float x) {
    if (x > 0.5f) return 1.0f - exp2(-x);
    float y = 0.6931471805599453f * x; // log(2)
    return y * (1.0f - y / 2.0f * (1.0f - y / 3.0f * (1.0f - y / 4.0f * (1.0f - y / 5.0f *
           (1.0f - y / 6.0f * (1.0f - y / 7.0f))))));
}

// cos(theta)^exponent in front of the axis and 0 behind it, exponent 0 included, where pow() would
// be left with an undefined 0^0. For any exponent from 0 to 1e6 the relative error is about
// 1e-7 (4 + 6 |log2 of the result|) on any device that keeps to Vulkan's limits.
SHARED float chord_power(float chord, float exponent) {
    if (chord >= 1.0f) return 0.0f;
    return exp2(exponent * log2_one_minus(chord));
}

// Density per steradian on the axis, where it is largest.
SHARED float lobe_peak(Lobe lobe) {
    switch (lobe.kind) {
    case LOBE_LAMBERT:
        return 1.0f / PI;
    case LOBE_PHONG: // Phong 1975, "Illumination for Computer Generated Pictures", normalised
        return (lobe.exponent + 1.0f) / (2.0f * PI);
    }
    return 0.0f;
}

// The lobe's weight at `chord` from its axis, as a share of its peak.
SHARED float lobe_weight(Lobe lobe, float chord) {
    switch (lobe.kind) {
    case LOBE_LAMBERT:
        return chord < 1.0f ? 1.0f - chord : 0.0f;
    case LOBE_PHONG:
        return chord_power(chord, lobe.exponent);
    }
    return 0.0f;
}

// Density per steradian at `chord` from the axis. Integrates to 1 over the sphere, so blurring
// leaves a uniform environment as it is.
SHARED float lobe_density(Lobe lobe, float chord) {
    return lobe_peak(lobe) * lobe_weight(lobe, chord);
}

// Chord of a direction drawn from the lobe, for `u` in [0, 1). `u` is the share of the lobe that is
// nearer to the axis than the result.
SHARED float lobe_sample_chord(Lobe lobe, float u) {
    switch (lobe.kind) {
    case LOBE_LAMBERT:
        return one_minus_exp2(-log2_one_minus(u) / 2.0f);
    case LOBE_PHONG:
        return one_minus_exp2(-log2_one_minus(u) / (lobe.exponent + 1.0f));
    }
    return 0.0f;
}

// The normalised Phong BRDF for two directions above the horizon, per steradian. `mirror_chord` lies
// between one of them and the other's mirror direction; which one does not matter. Lafortune and
// Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based Rendering".
SHARED float phong_brdf(float diffuse, float specular, float exponent, float mirror_chord) {
    return diffuse / PI +
           specular * (exponent + 2.0f) / (2.0f * PI) * chord_power(mirror_chord, exponent);
}

#endif
