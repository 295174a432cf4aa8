// What the prefilter learns from the texels: the suns it takes out of the map and the scale of what
// stays. Lies in one storage buffer; binding STATE_BINDING of set 0.
#ifndef PREFILTER_STATE_GLSL
#define PREFILTER_STATE_GLSL

#include "lobelia/suns.glsl"
#include "radiance.glsl"

layout(set = 0, binding = STATE_BINDING, std430) buffer State { PrefilterState state; };

float luminance(vec3 radiance) { return dot(radiance, vec3(0.2126, 0.7152, 0.0722)); }

// Chord of the radius within which bright texels make up one sun: 0.04 radians.
const float SUN_CHORD = 0.0001125;

// Whether one of the first `suns` suns has taken the bright texels at `direction`.
bool near_sun(vec3 direction, uint suns) {
    for (uint i = 0u; i < suns; ++i) {
        if (half_square_distance(direction, state.seeds[i].xyz) < SUN_CHORD) return true;
    }
    return false;
}

#endif
