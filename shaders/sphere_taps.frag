#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/suns.glsl"
#include "sphere_pass.glsl"

layout(constant_id = 4) const uint TAPS = 2u; // 1, 2 or 5
layout(constant_id = 6) const bool SUNS = true;

layout(set = 0, binding = 1) uniform samplerCube diffuse_map;
layout(set = 0, binding = 2) uniform sampler2DArray ladder;
layout(set = 0, binding = 3) uniform sampler2DArray tables;
layout(set = 0, binding = 4, std140) uniform State { PrefilterState state; };

#define PREFILTER_STATE state
#include "lobelia/taps.glsl"

vec3 specular_average(SurfacePoint point, float cos_theta, float n) {
    if (TAPS == 1u) return one_tap(ladder, tables, point.mirror, point.normal, cos_theta, n);
    if (TAPS == 2u) return two_taps(ladder, tables, point.mirror, point.normal, cos_theta, n);
    return five_taps(ladder, tables, point.mirror, point.normal, cos_theta, n);
}

vec3 surface_radiance(SurfacePoint point) {
    float n = params.exponent;
    float cos_theta = clamp(point.cos_view, 0.0, 1.0);
    vec3 diffuse = DIFFUSE ? diffuse_colour() : vec3(0.0);
    vec3 specular = SPECULAR ? specular_colour() : vec3(0.0);
    vec3 radiance = vec3(0.0);
    if (DIFFUSE) radiance += diffuse * textureLod(diffuse_map, point.normal, 0.0).rgb / state.scale;
    if (SPECULAR)
        radiance += specular * phong_albedo(cos_theta, n) * specular_average(point, cos_theta, n);
    if (SUNS) radiance += shade_suns(diffuse, specular, n, point.mirror, point.normal);
    return radiance;
}
