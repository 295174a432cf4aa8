// Maps for exponents that vary from pixel to pixel: a ladder of exponents, lowest, lowest * r,
// lowest * r^2 and so on, for C++ and GLSL alike. Between two rungs maps are mixed linearly in
// 1 / exponent, the lobe's variance: of the variables that the field uses it has the smallest error,
// which falls with the square of log r (docs/shading.md).
#ifndef LOBELIA_LADDER_GLSL
#define LOBELIA_LADDER_GLSL

#include "lobelia/language.glsl"

const float LADDER_RATIO = 1.41421356f;

// Between rungs `rung` and `rung` + 1, `share` of the latter.
struct LadderPlace {
    float rung;
    float share;
};

SHARED float ladder_exponent(float lowest, float rung) { return lowest * exp2(0.5f * rung); }

// Where a lobe of variance 1 / exponent is read on a ladder of `rungs`, at least two; beyond its ends
// the nearest rung.
SHARED LadderPlace ladder_place(float lowest, float rungs, float variance) {
    float at = -2.0f * log2(variance * lowest);
    LadderPlace place;
    place.rung = min(max(floor(at), 0.0f), rungs - 2.0f);
    float left = variance * ladder_exponent(lowest, place.rung); // of the rung's variance
    place.share = min(max((1.0f - left) / (1.0f - 1.0f / LADDER_RATIO), 0.0f), 1.0f);
    return place;
}

#endif
