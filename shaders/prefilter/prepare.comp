// The source as the chain reads it: sane, averaged over blocks where no map is so sharp as to see its
// texels, scaled, as halves. A second dispatch goes over the neighbourhoods of the suns alone and cuts
// them down to the threshold: a CPU device walks through every branch for every texel.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

layout(constant_id = 0) const bool AT_SUNS = false;
layout(constant_id = 1) const bool ONE_TEXEL = false; // blocks are of one texel

#include "lobelia/suns.glsl"
#include "radiance.glsl"
layout(set = 0, binding = 1, std140) uniform State { PrefilterState state; };
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

vec3 without_sun(vec3 radiance, vec3 direction) {
    float light = luminance(radiance);
    bool cut = light > state.threshold && near_sun(direction, MOST_SUNS);
    return cut ? radiance * (state.threshold / light) : radiance;
}

vec3 block_average(uvec3 texel) {
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    uint side = ONE_TEXEL ? 1u : block;
    for (uint j = 0u; j < side; ++j) {
        for (uint i = 0u; i < side; ++i) {
            uvec3 from = uvec3(texel.xy * side + uvec2(i, j), texel.z);
            float u = cube_texel_centre(from.x, size * side);
            float v = cube_texel_centre(from.y, size * side);
            vec3 radiance = sane(texelFetch(source, ivec3(from), 0).rgb);
            float shrink = inversesqrt(1.0 + u * u + v * v);
            float weight = shrink * shrink * shrink;
            if (AT_SUNS) radiance = without_sun(radiance, shrink * cube_direction(texel.z, u, v));
            sum += weight * state.scale * radiance;
            weights += weight;
        }
    }
    return sum / weights;
}

// The invocation's texel of the window around a sun on a face; outside the face where there is none.
uvec3 texel_at_sun() {
    uint face = gl_WorkGroupID.z % CUBE_FACES;
    vec3 sun = state.seeds[gl_WorkGroupID.z / CUBE_FACES].xyz;
    vec3 ahead = cube_direction(face, 0.0, 0.0);
    float depth = dot(sun, ahead);
    if (depth < 0.5) return uvec3(size);
    vec2 at = vec2(dot(sun, cube_direction(face, 1.0, 0.0) - ahead),
                   dot(sun, cube_direction(face, 0.0, 1.0) - ahead)) / depth;
    ivec2 centre = ivec2(floor((at + 1.0) * 0.5 * float(size)));
    ivec2 window = ivec2(gl_NumWorkGroups.xy * gl_WorkGroupSize.xy);
    return uvec3(centre - window / 2 + ivec2(gl_GlobalInvocationID.xy), face); // below 0 wraps
}

void main() {
    uvec3 texel = AT_SUNS ? texel_at_sun() : gl_GlobalInvocationID;
    if (texel.x >= size || texel.y >= size) return;
    store_texel(texel, size, margin, block_average(texel));
}
