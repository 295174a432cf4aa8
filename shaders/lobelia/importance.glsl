// Importance sampling of a lobe: which directions to look in and how wide each look is, for C++ and
// GLSL alike. A sample of N stands for 1 / N of the lobe:
//     P_n(axis) is the mean of textureLod(map, sample.direction, sample.level) over the N samples,
// or of the level 0 without filtering. The same points serve every axis, as is usual.
#ifndef LOBELIA_IMPORTANCE_GLSL
#define LOBELIA_IMPORTANCE_GLSL

#include "lobelia/direction.glsl"
#include "lobelia/lobe.glsl"

// Point i of N of the Hammersley set: its share of the lobe, in the middle of a stratum, in (0, 1),
// and its turn about the axis, in [-1/2, 1/2).
struct SamplePoint {
    float share;
    float turn;
};

SHARED SamplePoint sample_point(uint i, uint count) {
    SamplePoint point;
    point.share = (float(i) + 0.5f) / float(count);
    point.turn = float(bitfieldReverse(i) >> 8) / 16777216.0f - 0.5f; // all that a float holds
    return point;
}

// Two unit vectors across `axis` and each other. Duff et al. 2017, "Building an Orthonormal Basis,
// Revisited".
struct LobeFrame {
    vec3 axis;
    vec3 right;
    vec3 up;
};

SHARED LobeFrame lobe_frame(vec3 axis) {
    float side = axis.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (side + axis.z);
    float b = axis.x * axis.y * a;
    LobeFrame frame;
    frame.axis = axis;
    frame.right = vec3(1.0f + side * axis.x * axis.x * a, side * b, -side * axis.x);
    frame.up = vec3(b, side + axis.y * axis.y * a, -axis.y);
    return frame;
}

// The unit vector at `chord` from the axis (see lobelia/lobe.glsl), turned about it.
SHARED vec3 direction_about(LobeFrame frame, float chord, float turn) {
    float across = sqrt(chord * (2.0f - chord));
    return (1.0f - chord) * frame.axis + across * cos_turns(turn) * frame.right +
           across * sin_turns(turn) * frame.up;
}

// Level of a cube map with faces of `size` texels at which a texel covers the solid angle that one
// of `count` samples of that density towards `direction` stands for. Krivanek and Colbert 2008,
// "Real-time Shading with Filtered Importance Sampling"; the texel's solid angle is the one there,
// 4 / size^2 times the cubed cosine to the face's axis.
SHARED float sample_level(float density, uint count, vec3 direction, float size) {
    float cosine = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
    float texel_solid_angle = 4.0f * cosine * cosine * cosine / (size * size);
    return max(-0.5f * log2(float(count) * density * texel_solid_angle), 0.0f);
}

// Sample i of `count`, for a map with faces of `size` texels at level 0.
struct LobeSample {
    vec3 direction; // a unit vector
    float level;
};

SHARED LobeSample lobe_sample(Lobe lobe, LobeFrame frame, uint i, uint count, float size) {
    SamplePoint point = sample_point(i, count);
    float chord = lobe_sample_chord(lobe, point.share);
    LobeSample result;
    result.direction = direction_about(frame, chord, point.turn);
    result.level = sample_level(lobe_density(lobe, chord), count, result.direction, size);
    return result;
}

#endif
