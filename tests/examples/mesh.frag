// The engine's material, under Lobelia's light: gold on enamel, told apart and made uneven by a texture.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/suns.glsl" // PrefilterState
#include "mesh.glsl"

// [shade]
layout(set = 0, binding = 0) uniform samplerCube diffuse_map;
layout(set = 0, binding = 1) uniform sampler2DArray ladder;
layout(set = 0, binding = 2) uniform sampler2DArray tables;
layout(set = 0, binding = 3, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 4) uniform sampler2D relief; // tangent-space normal, and where the gold is

#define PREFILTER_STATE state
#include "lobelia/taps.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec3 world_tangent;
layout(location = 3) in vec2 texture_place;

layout(location = 0) out vec4 colour;

layout(constant_id = 0) const bool PLAIN = false; // one grey material, as `lobelia render` has

void main() {
    vec3 normal = normalize(world_normal);
    vec3 diffuse = vec3(0.3);
    vec3 specular = vec3(0.6);
    float exponent = 64.0;
    if (!PLAIN) {
        vec4 texel = texture(relief, texture_place);
        vec3 bump = 2.0 * texel.xyz - 1.0;
        vec3 tangent = normalize(world_tangent - dot(world_tangent, normal) * normal);
        normal = normalize(bump.x * tangent + bump.y * cross(tangent, normal) + bump.z * normal);
        diffuse = mix(vec3(0.01, 0.05, 0.16), vec3(0.04, 0.025, 0.005), texel.a);
        specular = mix(vec3(0.09), vec3(0.95, 0.72, 0.3), texel.a);
        exponent = mix(700.0, 90.0, texel.a);
    }
    vec3 view = normalize(eye.xyz - world_position);
    colour = vec4(shade(diffuse_map, ladder, tables, diffuse, specular, exponent, normal, view), 1.0);
}
// [shade]
