// One level of a cube map's mips: level 0 is the source made sane, each other one the averages of
// two by two texels of the level before, weighted equally or by their true solid angles, which add up
// to that of the texel they make: every level has the same mean. The shader that includes this says how
// the target is stored: TARGET_FORMAT and, for what is given to imageStore, ROUNDED(value).
#include "lobelia/cube.glsl"
#include "radiance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2DArray source; // the level before, or what is copied
layout(set = 0, binding = 1, TARGET_FORMAT) uniform writeonly image2DArray target;

layout(push_constant) uniform Params {
    uint size; // of the target
    uint copy;  // 1 for level 0
    uint equal; // 1 for equal weights
};

vec3 average(uvec3 texel) {
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint i = 0u; i < 4u; ++i) {
        uvec2 from = 2u * texel.xy + uvec2(i & 1u, i >> 1);
        float weight = equal == 1u ? 1.0 : cube_texel_solid_angle(from.x, from.y, 2u * size);
        sum += weight * texelFetch(source, ivec3(from, texel.z), 0).rgb;
        weights += weight;
    }
    return sum / weights;
}

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= size || texel.y >= size) return;
    vec3 value;
    if (copy == 1u)
        value = sane(texelFetch(source, ivec3(texel), 0).rgb);
    else
        value = average(texel);
    imageStore(target, ivec3(texel), vec4(ROUNDED(value), 1.0));
}
