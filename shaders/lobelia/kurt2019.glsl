// Shading as in Kurt 2019, "Real-Time Shading with Phong BRDF Model", section 3: light from six
// colours, one for each face of a blurred cube map. docs/shading.md says what the paper leaves open
// and what is chosen here. GLSL only: these functions sample textures. Their map is the environment
// averaged down to faces of 64 texels, at `level` of `blurred`.
//
// The samples' places are constant, so the six colours are the same for every pixel: a shader may
// have them computed once and call kurt2019_weighted() alone.
#ifndef LOBELIA_KURT2019_GLSL
#define LOBELIA_KURT2019_GLSL

#include "lobelia/albedo.glsl"
#include "lobelia/cube.glsl"

// The mean of nine samples of a face, in the middles of its ninths.
vec3 kurt2019_face(samplerCube blurred, float level, uint face) {
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec3 place = cube_direction(face, float(x) * (2.0 / 3.0), float(y) * (2.0 / 3.0));
            sum += textureLod(blurred, place, level).rgb;
        }
    return sum / 9.0;
}

struct Kurt2019Faces {
    vec3 right, left, top, bottom, front, back; // +X -X +Y -Y +Z -Z
};
Kurt2019Faces kurt2019_faces(samplerCube blurred, float level) {
    return Kurt2019Faces(
        kurt2019_face(blurred, level, 0u), kurt2019_face(blurred, level, 1u),
        kurt2019_face(blurred, level, 2u), kurt2019_face(blurred, level, 3u),
        kurt2019_face(blurred, level, 4u), kurt2019_face(blurred, level, 5u));
}

// The faces' mean, weighted by max(0, direction . normal of the face).
vec3 kurt2019_weighted(Kurt2019Faces faces, vec3 direction) {
    vec3 ahead = max(direction, 0.0);
    vec3 behind = max(-direction, 0.0);
    vec3 sum = ahead.x * faces.right + behind.x * faces.left + ahead.y * faces.top +
               behind.y * faces.bottom + ahead.z * faces.front + behind.z * faces.back;
    return sum / (abs(direction.x) + abs(direction.y) + abs(direction.z));
}

// How far the diffuse light goes over from the normal (0) to the mirror direction (1).
float kurt2019_gloss(float exponent) { return 1.0 - sqrt(2.0 / (exponent + 2.0)); }

// Radiance that each lobe sends to the eye, as published: 54 fetches for every sum. Without
// reflectance as factor.
vec3 kurt2019_diffuse(samplerCube blurred, float level, vec3 normal, vec3 mirror, float exponent) {
    return mix(kurt2019_weighted(kurt2019_faces(blurred, level), normal),
               kurt2019_weighted(kurt2019_faces(blurred, level), mirror), kurt2019_gloss(exponent));
}
vec3 kurt2019_specular(samplerCube blurred, float level, vec3 mirror, float cos_view,
                       float exponent) {
    return phong_albedo(cos_view, exponent) *
           kurt2019_weighted(kurt2019_faces(blurred, level), mirror);
}

#endif
