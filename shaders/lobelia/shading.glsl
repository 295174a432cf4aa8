// Shading with prefiltered maps, for an engine's own shaders: each map holds the normalised average
// of the environment over a Phong lobe about the direction it is read at, so that a lobe costs one
// fetch along its axis.
#ifndef LOBELIA_SHADING_GLSL
#define LOBELIA_SHADING_GLSL

#include "lobelia/albedo.glsl"

// Radiance that the diffuse lobe sends everywhere from a surface of unit normal `normal`; `map`
// holds the lobe of exponent 1.
vec3 shade_diffuse(samplerCube map, vec3 diffuse, vec3 normal) {
    return diffuse * textureLod(map, normal, 0.0).rgb;
}

// Radiance that the specular lobe sends to the eye. `mirror` is the unit vector in which a mirror
// would show the environment, `cos_view` the cosine from the normal to it; `map` holds the lobe of
// exponent `exponent`. The horizon darkens the lobe's average by its albedo.
vec3 shade_specular(samplerCube map, vec3 specular, float exponent, vec3 mirror, float cos_view) {
    return specular * phong_albedo(cos_view, exponent) * textureLod(map, mirror, 0.0).rgb;
}

#endif
