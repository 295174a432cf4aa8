// How maps are stored: texels of a map's format, and where they stand.
#ifndef PREFILTER_MAP_GLSL
#define PREFILTER_MAP_GLSL

#include "radiance.glsl"

#ifdef FLOAT_MAPS
#define MAP_FORMAT rgba32f
vec4 map_texel(vec3 average) { return vec4(average, 1.0); }
#else
#define MAP_FORMAT rgba16f
vec4 map_texel(vec3 average) { return vec4(nearest_half(average), 1.0); }
#endif

// The place on the face of texel `at` of a map of `size` texels: texel middles where `across` is `size`,
// and where it is one less a grid that ends on the face's edges, which needs no neighbours to be read
// bilinearly.
vec2 map_place(uvec2 at, uint size, uint across) {
    return (vec2(2u * at + 1u) - float(size)) / float(across);
}

// Where on the sphere a texel looks so that a filter even in the face's plane, which on the sphere draws
// what it reads towards the face's centre, finds there what belongs at `at`: docs/prefilter.md.
vec2 aim(vec2 at, float drift) { return at * (1.0 + drift / (1.0 + dot(at, at))); }

// Reading blurs by reading / square across the radial of the face, `square` the squared distance of its
// plane, and by reading / square^2 along it. A texel narrowed by the first is the mean of two that
// stand apart by the difference: what is added to and taken from the point `at` of the plane, in the
// face's frame (right, down, forward).
vec3 radial_difference(vec2 at, float reading) {
    float off_centre = dot(at, at);
    return vec3(at, -off_centre) * sqrt(reading) / (1.0 + off_centre);
}

#endif
