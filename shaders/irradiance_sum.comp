// Sums of `count` sums each, in order, so that they have the same bits every time: of a face's rows,
// and then of the faces.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/irradiance.glsl"

layout(local_size_x = IRRADIANCE_DEGREE_4) in;

layout(set = 0, binding = 0, std430) buffer Sums { vec4 sums[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Result { vec4 coefficients[]; };

layout(push_constant) uniform Params {
    uint from; // where the first sums begin
    uint to;   // where the new ones do
    uint count;
    uint last; // 1: these are the coefficients
};

void main() {
    uint i = gl_LocalInvocationID.x;
    uint group = gl_WorkGroupID.x;
    vec3 sum = vec3(0.0);
    for (uint k = 0u; k < count; ++k)
        sum += sums[from + (group * count + k) * IRRADIANCE_DEGREE_4 + i].rgb;
    if (last == 1u)
        coefficients[i] = vec4(irradiance_eigenvalue(i) * sum, 0.0);
    else
        sums[to + group * IRRADIANCE_DEGREE_4 + i] = vec4(sum, 0.0);
}
