// What the methods' times are relative to: a mirror that costs one trilinear fetch.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "sphere_pass.glsl"

layout(set = 0, binding = 1) uniform samplerCube mips;

vec3 surface_radiance(SurfacePoint point) {
    return specular_colour() * textureLod(mips, point.mirror, 1.5).rgb;
}
