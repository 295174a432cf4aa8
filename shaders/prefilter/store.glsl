// Texels of a level in memory, in storage buffer LEVEL_BINDING of set 0. A shader that reads them too
// defines LEVEL_ACCESS as nothing.
#ifndef PREFILTER_STORE_GLSL
#define PREFILTER_STORE_GLSL

#include "prefilter/chart.glsl"

#ifndef LEVEL_ACCESS
#define LEVEL_ACCESS writeonly
#endif
layout(set = 0, binding = LEVEL_BINDING, std430) LEVEL_ACCESS buffer Level { uvec2 level[]; };

// Where a texel lies; x and y from -margin to size + margin.
uint level_index(uint face, ivec2 texel, uint size, uint margin) {
    uint stride = size + 2u * margin;
    uvec2 place = uvec2(texel + int(margin));
    return (face * stride + place.y) * stride + place.x;
}

void store_texel(uvec3 texel, uint size, uint margin, vec3 value) {
    level[level_index(texel.z, ivec2(texel.xy), size, margin)] = pack_texel(value);
}

#endif
