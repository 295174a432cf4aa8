// Halves a level with the weights 1 3 3 1 a side, times solid angle: a cheap first step that hardly
// aliases. Its blur, three quarters of a squared texel in the face's plane, the next kernel leaves
// out.
#version 450
#extension GL_GOOGLE_include_directive : require

#define LEVEL_BINDING 1
#include "prefilter/store.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform usamplerBuffer source; // two texels an element

layout(push_constant) uniform Params {
    uint size;          // of the target
    uint margin;        // of the target
    uint source_margin; // even, at least 2
};

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= size || texel.y >= size) return;
    uint source_size = 2u * size;
    uint stride = source_size + 2u * source_margin;
    float width = 2.0 / float(source_size);

    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (uint j = 0u; j < 4u; ++j) {
        uint row = (texel.z * stride + 2u * texel.y + j - 1u + source_margin) * stride;
        float y = (float(2u * texel.y + j) - 0.5) * width - 1.0;
        for (uint i = 0u; i < 3u; ++i) {
            uvec4 pair = texelFetch(source, int((row + 2u * texel.x + 2u * i - 2u + source_margin) / 2u));
            for (uint k = 0u; k < 2u; ++k) {
                int column = int(2u * i + k) - 1; // from 0 to 3 within the weights
                if (column < 0 || column > 3) continue;
                float x = (float(2 * int(texel.x) + column) - 0.5) * width - 1.0;
                float weight = (column == 1 || column == 2 ? 3.0 : 1.0) *
                               (j == 1u || j == 2u ? 3.0 : 1.0) * chart_point(vec2(x, y), 0.0).density;
                if (weight == 0.0) continue; // nothing lies beyond a corner
                uvec2 halves = k == 0u ? pair.xy : pair.zw;
                sum += weight * UNPACKED * unpack_texel(halves);
                weights += weight;
            }
        }
    }
    store_texel(texel, size, margin, sum / weights);
}
