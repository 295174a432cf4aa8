// Reading prefiltered maps. GLSL only: these functions sample textures. Before it includes this file a
// shader defines PREFILTER_STATE, the PrefilterState in its buffer, as in
//     layout(set = 0, binding = 3, std140) uniform State { PrefilterState state; };
//     #define PREFILTER_STATE state
#ifndef LOBELIA_PREFILTERED_GLSL
#define LOBELIA_PREFILTERED_GLSL

#include "lobelia/cube.glsl"
#include "lobelia/suns.glsl"

// The texel weights of a cubic B-spline along one axis, folded into two bilinear taps: how far they
// lie from the texel before, and the share of the first. Sigg and Hadwiger 2005, "Fast Third-Order
// Texture Filtering".
struct SplineTaps {
    float first;
    float second;
    float share;
};

SplineTaps spline_taps(float t) {
    float s = 1.0 - t;
    float w0 = s * s * s / 6.0;
    float w1 = 2.0 / 3.0 - 0.5 * t * t * (2.0 - t);
    float w2 = 2.0 / 3.0 - 0.5 * s * s * (2.0 - s);
    float w3 = t * t * t / 6.0;
    return SplineTaps(w1 / (w0 + w1) - 1.0, w3 / (w2 + w3) + 1.0, w0 + w1);
}

// A level of `size` texels a face, read with a cubic B-spline: four bilinear fetches.
vec3 fetch_spline(samplerCube map, float size, vec3 direction) {
    CubePoint point = cube_point(direction);
    vec2 at = (vec2(point.u, point.v) + 1.0) * 0.5 * size - 0.5;
    vec2 texel = floor(at);
    SplineTaps x = spline_taps(at.x - texel.x);
    SplineTaps y = spline_taps(at.y - texel.y);
    float scale = 2.0 / size;
    vec2 low = (texel + vec2(x.first, y.first) + 0.5) * scale - 1.0;
    vec2 high = (texel + vec2(x.second, y.second) + 0.5) * scale - 1.0;
    vec3 top = mix(textureLod(map, cube_direction(point.face, high.x, low.y), 0.0).rgb,
                   textureLod(map, cube_direction(point.face, low.x, low.y), 0.0).rgb, x.share);
    vec3 bottom = mix(textureLod(map, cube_direction(point.face, high.x, high.y), 0.0).rgb,
                      textureLod(map, cube_direction(point.face, low.x, high.y), 0.0).rgb, x.share);
    return mix(bottom, top, y.share);
}

// P_n about `axis`, of unit length, from what a map of that exponent holds there: its scale undone and
// its suns added.
vec3 prefiltered_average(vec3 stored, vec3 axis, float exponent) {
    vec3 average = stored / PREFILTER_STATE.scale;
    uint left = PREFILTER_STATE.sun_count;
    if (left > 0u) do {
        average += sun_average(PREFILTER_STATE.suns[--left], axis, exponent);
    } while (left > 0u);
    return average;
}

// The same, with the fetch: of a map made for MapFilter::bilinear, and for MapFilter::spline.
vec3 prefiltered_bilinear(samplerCube map, vec3 axis, float exponent) {
    return prefiltered_average(textureLod(map, axis, 0.0).rgb, axis, exponent);
}
vec3 prefiltered_spline(samplerCube map, vec3 axis, float exponent) {
    float size = float(textureSize(map, 0).x);
    return prefiltered_average(fetch_spline(map, size, axis), axis, exponent);
}

#endif
