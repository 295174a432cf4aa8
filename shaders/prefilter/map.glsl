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

#endif
