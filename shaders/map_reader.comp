// P_n at a list of directions, from a prefiltered map: what an engine's shader would read there.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/suns.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 0) const bool SPLINE = false;

layout(set = 0, binding = 0) uniform samplerCube map;
layout(set = 0, binding = 1, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 2, std430) readonly buffer Directions { vec4 directions[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Results { vec4 results[]; };

#define PREFILTER_STATE state
#include "lobelia/prefiltered.glsl"

layout(push_constant) uniform Params {
    float exponent;
    uint first;
    uint count;
};

void main() {
    uint index = first + gl_GlobalInvocationID.x;
    if (index >= count) return;
    vec3 axis = directions[index].xyz;
    vec3 average = SPLINE ? prefiltered_spline(map, axis, exponent)
                          : prefiltered_bilinear(map, axis, exponent);
    results[index] = vec4(average, 1.0);
}
