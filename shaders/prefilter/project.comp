// Projects a level of the chain on spherical harmonics: each workgroup a chunk of its texels, each
// invocation one order.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "prefilter/chart.glsl"
#include "prefilter/harmonics.glsl"

layout(local_size_x = 32) in;

layout(set = 0, binding = 0) uniform usamplerBuffer source; // two texels an element
layout(set = 0, binding = 1, std430) writeonly buffer Partials { Term partials[]; };

layout(push_constant) uniform Params {
    uint size;   // of the source, even
    uint margin; // of the source
};

const uint CHUNK = 16u; // directions of one octant

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

vec2 power(vec2 base, int exponent) {
    vec2 result = vec2(1.0, 0.0);
    for (int bit = 1; bit <= DEGREE; bit *= 2) {
        if ((exponent & bit) != 0) result = times(result, base);
        base = times(base, base);
    }
    return result;
}

vec3 texel_at(uvec3 texel) {
    uint stride = size + 2u * margin;
    uint place = (texel.z * stride + texel.y + margin) * stride + texel.x + margin;
    uvec4 pair = texelFetch(source, int(place / 2u));
    uvec2 halves = (place & 1u) == 0u ? pair.xy : pair.zw;
    return vec3(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y).x);
}

// What a sum over texel middles takes too much at a face's edges, where the density ends with a slope:
// the Euler-Maclaurin formula's first term, as a share of the weight of the texels along the edge.
// `square` is |towards|^2.
float without_excess(vec3 towards, float square) {
    float share = 1.0;
    for (int i = 0; i < 3; ++i) {
        float across = towards[i]; // 1 on the face's axis
        bool at_edge = across < 1.0 && across * float(size) > float(size) - 1.5;
        if (at_edge) share -= 0.25 / (float(size) * (square + 1.0 - across * across));
    }
    return share;
}

// A constant that is taken out of the light before the sums, and put into degree 0 exactly: so constant
// light stays the constant, and the sums' errors are of what is left. The least of eight texels.
vec3 even_light() {
    vec3 least = vec3(65504.0);
    for (uint octant = 0u; octant < 8u; ++octant) {
        least = min(least, texel_at(mirrored_texel(0u, octant, size)));
    }
    return least;
}

void main() {
    int m = int(gl_LocalInvocationIndex);
    if (m > DEGREE) return;
    float up[ORDERS];
    float down[ORDERS];
    vec3 real[ORDERS];
    vec3 imaginary[ORDERS];
    [[unroll]] for (int l = 0; l <= DEGREE; ++l) {
        up[l] = l > m ? ascent(l, m) : 0.0;
        down[l] = l > m + 1 ? descent(l, m) : 0.0;
        real[l] = vec3(0.0);
        imaginary[l] = vec3(0.0);
    }
    float first = first_of_order(m);
    vec3 even = even_light();

    for (uint i = 0u; i < CHUNK; ++i) {
        uint index = gl_WorkGroupID.x * CHUNK + i;
        vec3 towards = octant_direction(index, size, octant_place(index, size, size));
        // The light of the eight texels, added with the signs of the harmonics of even and odd degree.
        vec3 real_light[2] = vec3[](vec3(0.0), vec3(0.0));
        vec3 imaginary_light[2] = vec3[](vec3(0.0), vec3(0.0));
        for (uint octant = 0u; octant < 8u; ++octant) {
            vec3 light = texel_at(mirrored_texel(index, octant, size)) - even;
            [[unroll]] for (int odd = 0; odd < 2; ++odd) {
                real_light[odd] += real_sign(octant, m & 1, (m + odd) & 1) * light;
                imaginary_light[odd] += imaginary_sign(octant, m & 1, (m + odd) & 1) * light;
            }
        }
        float square = dot(towards, towards);
        float shrink = inversesqrt(square);
        vec3 direction = towards * shrink;
        float density = shrink * shrink * shrink * without_excess(towards, square);
        vec2 sector = first * density * power(direction.xy, m);
        float before = 0.0;
        float here = 1.0;
        [[unroll]] for (int l = 0; l <= DEGREE; ++l) {
            if (l > m) {
                float next = up[l] * (direction.z * here - down[l] * before);
                before = here;
                here = next;
            }
            if (l >= m) {
                real[l] += here * sector.x * real_light[l & 1];
                imaginary[l] += here * sector.y * imaginary_light[l & 1];
            }
        }
    }
    float texel_area = 4.0 / (float(size) * float(size));
    uint base = gl_WorkGroupID.x * uint(TERMS);
    [[unroll]] for (int l = 0; l <= DEGREE; ++l) {
        if (l < m) continue;
        float ascending = l == m ? first : up[l];
        vec3 real_sum = real[l] * texel_area;
        if (l == 0 && gl_WorkGroupID.x == 0u) real_sum += even / first; // 1 / first is sqrt(4 pi)
        partials[base + uint(term(l, m))] =
            Term(vec4(real_sum, ascending), vec4(imaginary[l] * texel_area, l == m ? -1.0 : down[l]));
    }
}
