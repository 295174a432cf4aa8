// Shading with few fetches, for an engine's own shaders: the specular lobe, as the horizon cuts it,
// matched by one, two or five lobes of maps on a ladder of exponents, and the suns exactly. Works with
// a normal and an exponent of its own at every pixel. Before it includes this file a shader defines
// PREFILTER_STATE (see prefiltered.glsl). docs/shading.md has errors and costs.
#ifndef LOBELIA_TAPS_GLSL
#define LOBELIA_TAPS_GLSL

#include "lobelia/albedo.glsl"
#include "lobelia/clipped_lobe.glsl"
#include "lobelia/cube.glsl"
#include "lobelia/ladder.glsl"
#include "lobelia/suns.glsl"

// P about `towards`, of any length, of a lobe of variance 1 / exponent, but for the suns: two bilinear
// fetches. `ladder` is what Prefilter makes of a Ladder.
vec3 ladder_average(sampler2DArray ladder, vec3 towards, float variance) {
    vec3 size = vec3(textureSize(ladder, 0));
    LadderPlace place = ladder_place(PREFILTER_STATE.ladder_lowest, size.z / 6.0, variance);
    CubePoint point = cube_point(towards);
    // The first and the last texel's middles lie on the face's edges.
    vec2 at = 0.5 + 0.5 * (1.0 - 1.0 / size.x) * vec2(point.u, point.v);
    float layer = 6.0 * place.rung + float(point.face);
    return mix(textureLod(ladder, vec3(at, layer), 0.0).rgb,
               textureLod(ladder, vec3(at, layer + 6.0), 0.0).rgb, place.share) /
           PREFILTER_STATE.scale;
}

// What the horizon leaves of the lobe, as shares of its albedo W; `mirror` and `normal` of unit length,
// `tables` is what ClippedTables makes.
vec3 one_tap(sampler2DArray ladder, sampler2DArray tables, vec3 mirror, vec3 normal, float cos_theta,
             float exponent) {
    ClippedTablePoint at = clipped_table_point(cos_theta, exponent);
    vec4 texel = textureLod(tables, vec3(at.u, at.v, 0.0), 0.0);
    ClippedTaps taps = clipped_taps(texel.x, texel.y, texel.z, texel.w, cos_theta, exponent);
    return ladder_average(ladder, normal + taps.along_mirror * mirror, taps.one_tap_variance);
}

vec3 pair_average(sampler2DArray ladder, ClippedTaps taps, vec3 mirror, vec3 normal) {
    vec3 axis = normal + taps.along_mirror * mirror;
    vec3 across = taps.across * cross(normal, mirror);
    return 0.5 * (ladder_average(ladder, axis + across, taps.two_tap_variance) +
                  ladder_average(ladder, axis - across, taps.two_tap_variance));
}

vec3 two_taps(sampler2DArray ladder, sampler2DArray tables, vec3 mirror, vec3 normal,
              float cos_theta, float exponent) {
    ClippedTablePoint at = clipped_table_point(cos_theta, exponent);
    vec4 texel = textureLod(tables, vec3(at.u, at.v, 0.0), 0.0);
    return pair_average(
        ladder, clipped_taps(texel.x, texel.y, texel.z, texel.w, cos_theta, exponent), mirror, normal);
}

// The pair, less three sharper lobes along the horizon.
vec3 five_taps(sampler2DArray ladder, sampler2DArray tables, vec3 mirror, vec3 normal,
               float cos_theta, float exponent) {
    ClippedTablePoint at = clipped_table_point(cos_theta, exponent);
    vec4 texel = textureLod(tables, vec3(at.u, at.v, 1.0), 0.0);
    ClippedTaps taps = clipped_taps(texel.x, texel.y, texel.z, texel.w, cos_theta, exponent);
    HorizonTaps horizon = horizon_taps(cos_theta, exponent);
    vec3 middle = horizon.along_mirror * mirror + horizon.along_normal * normal;
    vec3 side = horizon.side * cross(normal, mirror);
    vec3 below = HORIZON_MIDDLE_SHARE * ladder_average(ladder, middle, horizon.middle_variance) +
                 0.5 * (1.0 - HORIZON_MIDDLE_SHARE) *
                     (ladder_average(ladder, middle + side, horizon.side_variance) +
                      ladder_average(ladder, middle - side, horizon.side_variance));
    float weight = texel.y;
    return max((1.0 + weight) * pair_average(ladder, taps, mirror, normal) - weight * below, 0.0);
}

// Radiance that the suns send to the eye, the horizon included.
vec3 shade_suns(vec3 diffuse, vec3 specular, float exponent, vec3 mirror, vec3 normal) {
    vec3 radiance = vec3(0.0);
    uint left = PREFILTER_STATE.sun_count;
    if (left > 0u) do {
        Sun sun = PREFILTER_STATE.suns[--left];
        float height = max(dot(sun.direction.xyz, normal), 0.0);
        vec3 lobe = specular * clipped_sun_lobe(sun, mirror, exponent) + diffuse / PI;
        radiance += height * lobe * sun.energy.rgb;
    } while (left > 0u);
    return radiance;
}

// Radiance that a surface sends to the eye by both lobes, the specular one by two taps: six bilinear
// fetches and a loop over the suns. All that describes the surface may change from pixel to pixel.
//   diffuse_map  P_1, Prefilter's map for `lambert`
//   ladder       Prefilter's, of ladder_for(Taps::two, least, most exponent)
//   tables       what ClippedTables makes; this and the two above with a linear sampler that clamps
//   diffuse, specular  reflectances kd and ks from 0 on, kd + ks <= 1 in each channel keeps energy
//   exponent     n of the lobe from 0 to 1e6; beyond the ladder's range its nearest rung stands in
//   normal, view of unit length, view towards the eye; a normal that faces away counts as level with it
vec3 shade(samplerCube diffuse_map, sampler2DArray ladder, sampler2DArray tables, vec3 diffuse,
           vec3 specular, float exponent, vec3 normal, vec3 view) {
    vec3 mirror = reflect(-view, normal);
    float cos_theta = clamp(dot(normal, view), 0.0, 1.0);
    vec3 average = textureLod(diffuse_map, normal, 0.0).rgb / PREFILTER_STATE.scale;
    vec3 gloss = two_taps(ladder, tables, mirror, normal, cos_theta, exponent);
    return diffuse * average + specular * phong_albedo(cos_theta, exponent) * gloss +
           shade_suns(diffuse, specular, exponent, mirror, normal);
}

#endif
