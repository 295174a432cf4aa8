// Fills the margins of a level: copies of the neighbouring faces' texels, as if the cube were unfolded.
#version 450
#extension GL_GOOGLE_include_directive : require

#define LEVEL_ACCESS
#define LEVEL_BINDING 0
#include "prefilter/store.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform Params {
    uint size;
    uint margin;
};

// The texel `beyond` texels behind one of the face's four edges, `along` it.
ivec2 margin_texel(uint edge, int along, int beyond) {
    int across = (edge & 1u) == 0u ? -1 - beyond : int(size) + beyond;
    return edge < 2u ? ivec2(across, along) : ivec2(along, across);
}

void main() {
    uvec2 at = gl_GlobalInvocationID.xy; // along the edge, and beyond it
    if (at.x >= size || at.y >= margin) return;
    uint face = gl_WorkGroupID.z / 4u;
    ivec2 texel = margin_texel(gl_WorkGroupID.z % 4u, int(at.x), int(at.y));
    vec3 p = chart_place((vec2(texel) + 0.5) * 2.0 / float(size) - 1.0);
    vec3 ahead = cube_direction(face, 0.0, 0.0);
    CubePoint point = cube_point(p.x * (cube_direction(face, 1.0, 0.0) - ahead) +
                                 p.y * (cube_direction(face, 0.0, 1.0) - ahead) + p.z * ahead);
    ivec2 from = ivec2((vec2(point.u, point.v) + 1.0) * 0.5 * float(size));
    level[level_index(face, texel, size, margin)] =
        level[level_index(point.face, from, size, margin)];
}
