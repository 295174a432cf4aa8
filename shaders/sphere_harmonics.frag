#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/albedo.glsl"
#include "lobelia/irradiance.glsl"
#include "lobelia/suns.glsl"
#include "sphere_pass.glsl"

layout(constant_id = 3) const bool SPLINE = false; // how the specular map is read
layout(constant_id = 4) const uint DEGREE = 2u;

layout(set = 0, binding = 1) uniform samplerCube specular_map;
layout(set = 0, binding = 2, std140) uniform State { PrefilterState state; };
layout(set = 0, binding = 3, std140) uniform Irradiance { vec4 coefficients[IRRADIANCE_DEGREE_4]; };

#define PREFILTER_STATE state
#include "lobelia/prefiltered.glsl"

vec3 surface_radiance(SurfacePoint point) {
    vec3 radiance = vec3(0.0);
    if (DIFFUSE) {
        uint count = DEGREE == 2u ? IRRADIANCE_DEGREE_2 : IRRADIANCE_DEGREE_4;
        radiance += diffuse_colour() * irradiance_average(coefficients, point.normal, count);
    }
    if (SPECULAR) {
        float n = params.exponent;
        vec3 average = SPLINE ? prefiltered_spline(specular_map, point.mirror, n)
                              : prefiltered_bilinear(specular_map, point.mirror, n);
        radiance += specular_colour() * phong_albedo(point.cos_view, n) * average;
    }
    return radiance;
}
