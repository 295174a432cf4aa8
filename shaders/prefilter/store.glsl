// Stores texels of a level in memory, with the copies in the margins of the neighbouring faces.
#ifndef PREFILTER_STORE_GLSL
#define PREFILTER_STORE_GLSL

#include "prefilter/chart.glsl"

layout(set = 0, binding = LEVEL_BINDING, std430) writeonly buffer Level { uvec2 level[]; };

void store_at(uint face, ivec2 at, uint size, uint margin, uvec2 packed_texel) {
    uint stride = size + 2u * margin;
    uvec2 place = uvec2(at + int(margin));
    level[(face * stride + place.y) * stride + place.x] = packed_texel;
}

void store_texel(uvec3 texel, uint size, uint margin, vec3 value) {
    uvec2 packed_texel = pack_texel(value);
    store_at(texel.z, ivec2(texel.xy), size, margin, packed_texel);

    uvec2 from_edge = min(texel.xy, size - 1u - texel.xy);
    if (min(from_edge.x, from_edge.y) >= margin) return;
    vec3 p = cube_direction(texel.z, cube_texel_centre(texel.x, size), cube_texel_centre(texel.y, size));
    for (uint face = 0u; face < CUBE_FACES; ++face) {
        vec3 ahead = cube_direction(face, 0.0, 0.0);
        float depth = (1.0 - dot(p, ahead)) * 0.5 * float(size); // texels behind the face's plane
        if (face / 2u == texel.z / 2u || depth > float(margin)) continue;
        float u = dot(p, cube_direction(face, 1.0, 0.0) - ahead);
        float v = dot(p, cube_direction(face, 0.0, 1.0) - ahead);
        int beyond = int(floor(depth));
        ivec2 at = ivec2(floor((vec2(u, v) + 1.0) * 0.5 * float(size)));
        if (abs(u) == 1.0) at.x = u > 0.0 ? int(size) + beyond : -1 - beyond;
        if (abs(v) == 1.0) at.y = v > 0.0 ? int(size) + beyond : -1 - beyond;
        store_at(face, at, size, margin, packed_texel);
    }
}

#endif
