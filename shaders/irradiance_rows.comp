// The environment's light times each basis function, summed over one row of a face: texels by their
// solid angle, made sane. A texel is even light over its area, so where texels are large each is cut
// into parts.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/irradiance.glsl"
#include "radiance.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, std430) writeonly buffer Sums { vec4 sums[]; };

layout(push_constant) uniform Params {
    uint size;  // of a face, parts
    uint shift; // log2 of how many parts a texel has a side
};

void main() {
    uint row = gl_GlobalInvocationID.x;
    uint face = gl_GlobalInvocationID.y;
    if (row >= size) return;
    vec3 sum[IRRADIANCE_DEGREE_4];
    for (uint i = 0u; i < IRRADIANCE_DEGREE_4; ++i) sum[i] = vec3(0.0);
    float v = cube_texel_centre(row, size);
    for (uint x = 0u; x < size; ++x) {
        vec3 direction = normalize(cube_direction(face, cube_texel_centre(x, size), v));
        vec3 light = cube_texel_solid_angle(x, row, size) *
                     sane(texelFetch(source, ivec3(x >> shift, row >> shift, face), 0).rgb);
        IrradianceBasis basis = irradiance_basis(direction);
        for (uint i = 0u; i < IRRADIANCE_DEGREE_4; ++i) sum[i] += basis.y[i] * light;
    }
    uint first = (face * size + row) * IRRADIANCE_DEGREE_4;
    for (uint i = 0u; i < IRRADIANCE_DEGREE_4; ++i) sums[first + i] = vec4(sum[i], 0.0);
}
