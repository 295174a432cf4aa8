#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/albedo.glsl"
#include "sphere_pass.glsl"

layout(set = 0, binding = 1) readonly buffer Diffuse { vec4 diffuse_average[]; };
layout(set = 0, binding = 2) readonly buffer Specular { vec4 specular_average[]; };

vec3 surface_radiance(SurfacePoint point) {
    uint pixel = uint(gl_FragCoord.y) * params.width + uint(gl_FragCoord.x);
    vec3 radiance = vec3(0.0);
    if (DIFFUSE) radiance += diffuse_colour() * diffuse_average[pixel].rgb;
    if (SPECULAR)
        radiance += specular_colour() * phong_albedo(point.cos_view, params.exponent) *
                    specular_average[pixel].rgb;
    return radiance;
}
