#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/kurt2019.glsl"
#include "sphere_pass.glsl"

layout(set = 0, binding = 1) uniform samplerCube blurred;

vec3 surface_radiance(SurfacePoint point) {
    float n = params.exponent;
    float level = float(textureQueryLevels(blurred) - 1);
    vec3 radiance = vec3(0.0);
    if (DIFFUSE)
        radiance += diffuse_colour() * kurt2019_diffuse(blurred, level, point.normal, point.mirror, n);
    if (SPECULAR)
        radiance += specular_colour() *
                    kurt2019_specular(blurred, level, point.mirror, point.cos_view, n);
    return radiance;
}
