#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/suns.glsl"

// A prefiltered map at a list of directions, read as a shader of an engine reads it.
layout(local_size_x = 64) in;

layout(set = 0, binding = 0) uniform samplerCube map;
layout(set = 0, binding = 1, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 2, std430) readonly buffer Directions { vec4 directions[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Averages { vec4 averages[]; };

layout(push_constant) uniform Params {
    float exponent;
    uint spline; // 1 for MapFilter::spline
};

#define PREFILTER_STATE state
#include "lobelia/prefiltered.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(directions.length())) return;
    vec3 axis = directions[i].xyz;
    averages[i] = vec4(spline == 1u ? prefiltered_spline(map, axis, exponent)
                                    : prefiltered_bilinear(map, axis, exponent),
                       1.0);
}
