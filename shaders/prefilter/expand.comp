// A map of a low exponent from spherical harmonics: each degree times the lobe's eigenvalue.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "prefilter/chart.glsl"
#include "prefilter/harmonics.glsl"
#include "prefilter/map.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Terms { Term terms[]; };
layout(set = 0, binding = 1, MAP_FORMAT) uniform writeonly image2DArray map;

layout(push_constant) uniform Params {
    uint size_across;          // of the map; across in the upper half, see map_place()
    int degree;                // of the series
    float reading;             // variance that reading the map adds in the face's plane
    float eigenvalues[ORDERS]; // of the lobe, over those of the blurs before and after
};

shared Term scaled[TERMS]; // with the eigenvalues

void load_terms() {
    for (int m = 0; m <= degree; ++m) {
        int l = m + int(gl_LocalInvocationIndex);
        if (l > degree) continue;
        Term entry = terms[term(l, m)];
        entry.real.rgb *= eigenvalues[l];
        entry.imaginary.rgb *= eigenvalues[l];
        scaled[term(l, m)] = entry;
    }
    barrier();
}

// Four texels an invocation, so that a term once fetched serves them all, and two points a texel, which
// are averaged: the degrees leave out what reading blurs across the radial, but along it reading blurs
// less, which the points' distance gives back.
const int TEXELS = 4;
const int POINTS = 2 * TEXELS;

vec3 directions[POINTS];
vec2 powers[POINTS]; // (x + i y)^m
float before[POINTS];
float here[POINTS]; // the recurrence's last two values
float excesses[TEXELS];
vec3 order_sums[4 * POINTS]; // of an order's even and odd l + m, real parts and imaginary ones
// By the kind of harmonic: whether m, and whether l + m, is odd.
vec3 real[4 * TEXELS];
vec3 imaginary[4 * TEXELS];

void begin_texel(int texel, uint index, uint size) {
    vec2 place = aim(octant_place(index, size, size_across >> 16), reading);
    float square = 1.0 + dot(place, place);
    vec3 towards = octant_direction(index, size, place);
    vec3 apart = octant_vector(index, size, radial_difference(place, reading));
    directions[2 * texel] = normalize(towards + apart);
    directions[2 * texel + 1] = normalize(towards - apart);
    excesses[texel] = 0.5 * reading * (1.0 / square - MEAN_READING);
    for (int kind = 0; kind < 4; ++kind) {
        real[4 * texel + kind] = vec3(0.0);
        imaginary[4 * texel + kind] = vec3(0.0);
    }
}

// What reading blurs of a harmonic of degree l, beyond the share that is in the eigenvalues, when it is
// left out: exp(l (l + 1) excess).
float sharpened(int l, float excess) {
    float x = float(l * (l + 1)) * excess;
    return 1.0 + x * (1.0 + 0.5 * x);
}

void add_term(int l, int odd, Term entry) {
    float sharp[TEXELS];
    [[unroll]] for (int i = 0; i < TEXELS; ++i) sharp[i] = sharpened(l, excesses[i]);
    [[unroll]] for (int i = 0; i < POINTS; ++i) {
        float value = entry.real.w * (directions[i].z * here[i] - entry.imaginary.w * before[i]);
        before[i] = here[i];
        here[i] = value;
        order_sums[4 * i + odd] += value * sharp[i / 2] * entry.real.rgb;
        order_sums[4 * i + 2 + odd] += value * sharp[i / 2] * entry.imaginary.rgb;
    }
}

void add_order(int m) {
    [[unroll]] for (int i = 0; i < 4 * POINTS; ++i) order_sums[i] = vec3(0.0);
    [[unroll]] for (int i = 0; i < POINTS; ++i) {
        before[i] = 1.0;
        here[i] = 0.0;
    }
    int index = term(m, m);
    for (int l = m; l <= degree; l += 2) {
        add_term(l, 0, scaled[index]);
        if (l == degree) break;
        add_term(l + 1, 1, scaled[index + 1]);
        index += 2;
    }
    int kind = 2 * (m & 1);
    [[unroll]] for (int i = 0; i < POINTS; ++i) {
        [[unroll]] for (int odd = 0; odd < 2; ++odd) {
            real[4 * (i / 2) + kind + odd] += powers[i].x * order_sums[4 * i + odd];
            imaginary[4 * (i / 2) + kind + odd] += powers[i].y * order_sums[4 * i + 2 + odd];
        }
        vec3 d = directions[i];
        powers[i] = vec2(powers[i].x * d.x - powers[i].y * d.y, powers[i].x * d.y + powers[i].y * d.x);
    }
}

void store_mirrored(int texel, uint index, uint size) {
    for (uint octant = 0u; octant < 8u; ++octant) {
        vec3 sum = vec3(0.0);
        [[unroll]] for (int kind = 0; kind < 4; ++kind) {
            sum += real_sign(octant, kind / 2, kind & 1) * real[4 * texel + kind] +
                   imaginary_sign(octant, kind / 2, kind & 1) * imaginary[4 * texel + kind];
        }
        uvec3 at = mirrored_texel(index, octant, size);
        imageStore(map, ivec3(at), map_texel(max(0.5 * sum, 0.0)));
    }
}

void main() {
    load_terms();
    uint index = uint(TEXELS) * gl_GlobalInvocationID.x;
    uint size = size_across & 0xffffu;
    if (index >= 3u * size * size / 4u) return;
    [[unroll]] for (int i = 0; i < TEXELS; ++i) begin_texel(i, index + uint(i), size);
    [[unroll]] for (int i = 0; i < POINTS; ++i) powers[i] = vec2(1.0, 0.0);
    for (int m = 0; m <= degree; ++m) add_order(m);
    [[unroll]] for (int i = 0; i < TEXELS; ++i) store_mirrored(i, index + uint(i), size);
}
