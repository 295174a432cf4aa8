#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/shading.glsl"
#include "sphere_pass.glsl"

layout(set = 0, binding = 1) uniform samplerCube diffuse_map;
layout(set = 0, binding = 2) uniform samplerCube specular_map;

vec3 surface_radiance(SurfacePoint point) {
    vec3 radiance = vec3(0.0);
    if (DIFFUSE) radiance += shade_diffuse(diffuse_map, diffuse_colour(), point.normal);
    if (SPECULAR)
        radiance += shade_specular(specular_map, specular_colour(), params.exponent, point.mirror,
                                   point.cos_view);
    return radiance;
}
