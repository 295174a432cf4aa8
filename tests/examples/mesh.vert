// The engine's mesh: positions and tangent frames in the world.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mesh.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 place;

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec3 world_tangent;
layout(location = 3) out vec2 texture_place;

void main() {
    world_position = position;
    world_normal = normal;
    world_tangent = tangent;
    texture_place = place;
    gl_Position = clip_from_world * vec4(position, 1.0);
}
