// A cube map in another size, area-true: each texel is the average of the source, made sane, over
// the texel's solid angle.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "radiance.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0) uniform sampler2DArray source;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2DArray target;

layout(push_constant) uniform Params {
    uint source_size;
    uint size; // of the target
};

// The part of target texel `texel` that lies in source texel `from`, along one axis, in face
// coordinates from -1 to 1. A face counts size * source_size units first, of which the edges of all
// texels are whole numbers.
struct Overlap {
    float low;
    float high;
    float extent;
};

Overlap overlap(uint texel, uint from) {
    uint low = max(texel * source_size, from * size);
    uint high = min((texel + 1u) * source_size, (from + 1u) * size);
    float unit = 2.0 / float(size * source_size);
    return Overlap(float(low) * unit - 1.0, float(high) * unit - 1.0, float(high - low) * unit);
}

void main() {
    uvec3 texel = gl_GlobalInvocationID;
    if (texel.x >= size) return;
    uvec2 first = texel.xy * source_size / size;
    uvec2 last = ((texel.xy + 1u) * source_size - 1u) / size;
    vec4 sum = vec4(0.0);
    vec3 least = vec3(3.4028235e38);
    vec3 most = vec3(0.0);
    for (uint y = first.y; y <= last.y; ++y) {
        Overlap down = overlap(texel.y, y);
        for (uint x = first.x; x <= last.x; ++x) {
            Overlap across = overlap(texel.x, x);
            float weight = cube_solid_angle(across.low, down.low, across.high, down.high,
                                            across.extent * down.extent);
            vec3 radiance = sane(texelFetch(source, ivec3(x, y, texel.z), 0).rgb);
            sum += weight * vec4(radiance, 1.0);
            least = min(least, radiance);
            most = max(most, radiance);
        }
    }
    imageStore(target, ivec3(texel), vec4(clamp(sum.rgb / sum.a, least, most), 1.0));
}
