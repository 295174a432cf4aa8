// What the prefilter learns from the texels: the suns it takes out of the map and the scale of what
// stays. A shader that includes this declares `state`, a PrefilterState in its buffer.
#ifndef PREFILTER_STATE_GLSL
#define PREFILTER_STATE_GLSL

// Chord of the radius within which bright texels make up one sun: 0.015 radians.
const float SUN_CHORD = 0.0001125;

// Whether one of the first `suns` suns has taken the bright texels at `direction`.
bool near_sun(vec3 direction, uint suns) {
    bool near = false;
    for (uint i = 0u; i < suns; ++i) {
        near = near || half_square_distance(direction, state.seeds[i].xyz) < SUN_CHORD;
    }
    return near;
}

#endif
