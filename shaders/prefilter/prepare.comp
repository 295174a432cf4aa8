// The source as the chain reads it: sane, its suns cut down to the threshold, averaged over blocks
// where no map is so sharp as to see them, scaled, as halves.
#version 450
#extension GL_GOOGLE_include_directive : require

#define STATE_BINDING 1
#include "prefilter/state.glsl"
#define LEVEL_BINDING 2
#include "prefilter/store.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2DArray source;

layout(push_constant) uniform Params {
    uint size;   // of the target
    uint margin; // of the target
    uint block;  // source texels a side of one of the target
};

vec3 without_sun(vec3 radiance, vec3 towards) {
    float light = luminance(radiance);
    if (light <= state.threshold || !near_sun(normalize(towards), state.sun_count)) return radiance;
    return radiance * (state.threshold / light);
}

vec3 block_average(uvec3 texel) {
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint j = 0u; j < block; ++j) {
        for (uint i = 0u; i < block; ++i) {
            uvec3 from = uvec3(texel.xy * block + uvec2(i, j), texel.z);
            float u = cube_texel_centre(from.x, size * block);
            float v = cube_texel_centre(from.y, size * block);
            vec3 radiance = sane(texelFetch(source, ivec3(from), 0).rgb);
            float shrink = inversesqrt(1.0 + u * u + v * v);
            float weight = shrink * shrink * shrink;
            sum += weight * state.scale * without_sun(radiance, cube_direction(texel.z, u, v));
            weights += weight;
        }
    }
    return sum / weights;
}

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= size || texel.y >= size) return;
    store_texel(texel, size, margin, block_average(texel));
}
