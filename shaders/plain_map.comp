// A prefiltered map as a cube map that is read without its scale, its suns and its filter.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/suns.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool SPLINE = false;

layout(set = 0, binding = 0) uniform samplerCube map;
layout(set = 0, binding = 1, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 2, rgba32f) uniform writeonly image2DArray plain;

#define PREFILTER_STATE state
#include "lobelia/prefiltered.glsl"

layout(push_constant) uniform Params {
    float exponent;
    uint size; // of the target
};

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= size || texel.y >= size) return;
    vec3 axis = normalize(cube_direction(texel.z, cube_texel_centre(texel.x, size),
                                         cube_texel_centre(texel.y, size)));
    vec3 average = SPLINE ? prefiltered_spline(map, axis, exponent)
                          : prefiltered_bilinear(map, axis, exponent);
    imageStore(plain, ivec3(texel), vec4(average, 1.0));
}
