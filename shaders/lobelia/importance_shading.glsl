// Shading at run time by filtered importance sampling. Krivanek and Colbert 2008, "Real-time Shading
// with Filtered Importance Sampling": `count` directions drawn from a lobe, each looked up at the
// level whose texels cover the sample's share of the sphere. GLSL only: these functions sample
// textures. `map` is the environment with all its levels, each of the same mean (lobelia/mips.h).
//
// The points are the same for every pixel, so an engine may keep their chords and turns in a table of
// `count` entries for its exponent; here they are computed.
#ifndef LOBELIA_IMPORTANCE_SHADING_GLSL
#define LOBELIA_IMPORTANCE_SHADING_GLSL

#include "lobelia/importance.glsl"

// P_1 about the normal: what the diffuse lobe sends everywhere, without kd.
vec3 importance_diffuse(samplerCube map, vec3 normal, uint count) {
    Lobe lobe = Lobe(LOBE_LAMBERT, 1.0);
    LobeFrame frame = lobe_frame(normal);
    float size = float(textureSize(map, 0).x);
    float share = 1.0 / float(count); // on each, so that no sum overflows
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        LobeSample look = lobe_sample(lobe, frame, i, count, size);
        sum += share * textureLod(map, look.direction, look.level).rgb;
    }
    return sum;
}

// What the specular lobe sends to the eye, without ks. The samples have the density of the whole
// lobe, so the cosine that clips it at the horizon stays as their weight.
vec3 importance_specular(samplerCube map, vec3 normal, vec3 mirror, float exponent, uint count) {
    Lobe lobe = Lobe(LOBE_PHONG, exponent);
    LobeFrame frame = lobe_frame(mirror);
    float size = float(textureSize(map, 0).x);
    float share = (exponent + 2.0) / (exponent + 1.0) / float(count);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        LobeSample look = lobe_sample(lobe, frame, i, count, size);
        float weight = share * max(dot(normal, look.direction), 0.0);
        sum += weight * textureLod(map, look.direction, look.level).rgb;
    }
    return sum;
}

#endif
