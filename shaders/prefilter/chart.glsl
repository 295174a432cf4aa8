// How a level lies in memory while the prefilter works on it: each face with a margin around it in
// which the texels of its four neighbours are laid out as if the cube were unfolded. Between two
// neighbours' strips, beyond a corner, there is nothing.
#ifndef PREFILTER_CHART_GLSL
#define PREFILTER_CHART_GLSL

#include "lobelia/cube.glsl"
#include "radiance.glsl"

// A place on the chart of a face: the point of the cube's surface in the face's own frame (right,
// down, forward), made a unit vector, and the solid angle per unit of the chart's area there.
struct ChartPoint {
    vec3 direction;
    float density;
};

// The point of the cube's surface.
vec3 chart_place(vec2 at) {
    vec2 on_face = clamp(at, -1.0, 1.0);
    vec2 beyond = abs(at - on_face);
    return vec3(on_face, 1.0 - beyond.x - beyond.y);
}

// `edge` is what sums over texel middles take too much there, at the edges of faces, where the density
// has a kink: as a share of the weight, times the squared distance of the face's plane.
ChartPoint chart_point(vec2 at, float edge) {
    vec3 p = chart_place(at);
    float shrink = inversesqrt(dot(p, p));
    bool nothing = abs(at.x) > 1.0 && abs(at.y) > 1.0;
    float square = shrink * shrink;
    return ChartPoint(p * shrink, nothing ? 0.0 : shrink * square * (1.0 - edge * square));
}

uvec2 pack_texel(vec3 value) {
    uvec3 halves = to_halves(value);
    return uvec2(halves.x | (halves.y << 16), halves.z | 0x3c000000u);
}

// Halves without sign, infinity and NaN become floats by a shift, too small by 2^112, which the
// weights make up for: the built-in functions cost a CPU device more than the fetch.
const float UNPACKED = 5.192296858534828e33;

vec3 unpack_texel(uvec2 halves) {
    return uintBitsToFloat(uvec3((halves.x & 0xffffu) << 13, (halves.x >> 3) & 0x0fffe000u,
                                 (halves.y & 0xffffu) << 13));
}

#endif
