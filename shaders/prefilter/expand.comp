// A map of a low exponent from spherical harmonics: each degree times the lobe's eigenvalue.
#version 450
#extension GL_GOOGLE_include_directive : require

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

// What reading blurs at `square`, the squared distance of the face's plane there, beyond the share of
// it that is in the eigenvalues: half the variance, taken as the same along the radial and across it.
float reading_beyond_mean(float square) {
    float here = 0.5 * (1.0 / square + 1.0 / (square * square));
    return 0.5 * reading * (here - MEAN_READING);
}

// What that makes of a harmonic of degree l when it is left out: exp(l (l + 1) excess).
float sharpened(int l, float excess) {
    float x = float(l * (l + 1)) * excess;
    return 1.0 + x * (1.0 + 0.5 * x);
}

// The sums over l of one order at height z, for even and odd l + m.
struct Order {
    vec3 real[2];
    vec3 imaginary[2];
};

Order sum_order(int m, float z, float excess) {
    Order sums = Order(vec3[](vec3(0.0), vec3(0.0)), vec3[](vec3(0.0), vec3(0.0)));
    int index = term(m, m);
    float before = 0.0;
    float here = scaled[index].real.w;
    for (int l = m; l <= degree; l += 2) {
        float even = here * sharpened(l, excess);
        sums.real[0] += even * scaled[index].real.rgb;
        sums.imaginary[0] += even * scaled[index].imaginary.rgb;
        if (l == degree) break;
        ++index;
        before = scaled[index].real.w * (z * here - scaled[index].imaginary.w * before);
        float odd = before * sharpened(l + 1, excess);
        sums.real[1] += odd * scaled[index].real.rgb;
        sums.imaginary[1] += odd * scaled[index].imaginary.rgb;
        if (l + 1 == degree) break;
        ++index;
        here = scaled[index].real.w * (z * before - scaled[index].imaginary.w * here);
    }
    return sums;
}

void main() {
    load_terms();
    uint index = gl_GlobalInvocationID.x;
    uint size = size_across & 0xffffu;
    if (index >= 3u * size * size / 4u) return;
    vec3 towards = octant_direction(index, size, size_across >> 16);
    vec3 direction = normalize(towards);
    float excess = reading_beyond_mean(dot(towards, towards));

    // Sums by the kind of harmonic: whether m, and whether l + m, is odd.
    vec3 real[4] = vec3[](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 imaginary[4] = vec3[](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec2 power = vec2(1.0, 0.0); // (x + i y)^m
    for (int m = 0; m <= degree; ++m) {
        Order order = sum_order(m, direction.z, excess);
        int kind = 2 * (m & 1);
        real[kind] += power.x * order.real[0];
        real[kind + 1] += power.x * order.real[1];
        imaginary[kind] += power.y * order.imaginary[0];
        imaginary[kind + 1] += power.y * order.imaginary[1];
        power = vec2(power.x * direction.x - power.y * direction.y,
                     power.x * direction.y + power.y * direction.x);
    }

    for (uint octant = 0u; octant < 8u; ++octant) {
        vec3 sum = vec3(0.0);
        for (int kind = 0; kind < 4; ++kind) {
            sum += real_sign(octant, kind / 2, kind & 1) * real[kind] +
                   imaginary_sign(octant, kind / 2, kind & 1) * imaginary[kind];
        }
        uvec3 texel = mirrored_texel(index, octant, size);
        imageStore(map, ivec3(texel), map_texel(max(sum, 0.0)));
    }
}
