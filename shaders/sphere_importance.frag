#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/importance_shading.glsl"
#include "sphere_pass.glsl"

layout(constant_id = 5) const uint SAMPLES = 64u; // of each lobe

layout(set = 0, binding = 1) uniform samplerCube mips;

vec3 surface_radiance(SurfacePoint point) {
    vec3 radiance = vec3(0.0);
    if (DIFFUSE) radiance += diffuse_colour() * importance_diffuse(mips, point.normal, SAMPLES);
    if (SPECULAR)
        radiance += specular_colour() * importance_specular(mips, point.normal, point.mirror,
                                                            params.exponent, SAMPLES);
    return radiance;
}
