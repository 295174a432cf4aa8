// Mean and largest luminance of every tile of 8 x 8 texels of the source. One invocation a tile: sums
// through shared memory cost a CPU device five times as much.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "radiance.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, std430) writeonly buffer Tiles { vec4 tiles[]; }; // mean, solid angle, most

layout(push_constant) uniform Params { uint size; };

void main() {
    uint across = size / 8u;
    uvec3 tile = gl_GlobalInvocationID;
    if (tile.x >= across || tile.y >= across) return;
    vec2 sum = vec2(0.0); // luminance times solid angle, solid angle
    float most = 0.0;
    for (uint y = 0u; y < 8u; ++y) {
        vec2 row = vec2(0.0);
        float v = cube_texel_centre(8u * tile.y + y, size);
        for (uint x = 0u; x < 8u; ++x) {
            ivec3 texel = ivec3(8u * tile.xy + uvec2(x, y), tile.z);
            float light = luminance(sane(texelFetch(source, texel, 0).rgb));
            float u = cube_texel_centre(8u * tile.x + x, size);
            float shrink = inversesqrt(1.0 + u * u + v * v);
            float weight = shrink * shrink * shrink;
            row += vec2(light, 1.0) * weight;
            most = max(most, light);
        }
        sum += row;
    }
    float texel_area = 4.0 / (float(size) * float(size));
    tiles[(tile.z * across + tile.y) * across + tile.x] =
        vec4(sum.x / sum.y, sum.y * texel_area, most, 0.0);
}
