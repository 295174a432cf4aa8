// A triangle over the whole picture, as far away as can be.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "mesh.glsl"

layout(location = 0) out vec3 along;

void main() {
    vec2 at = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
    along = ahead.xyz + at.x * right.xyz + at.y * down.xyz;
    gl_Position = vec4(at, 1.0, 1.0);
}
