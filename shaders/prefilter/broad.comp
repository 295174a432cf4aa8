// Maps of low exponents: direct sums over every texel of a small level, up to four maps at once. As
// in blur.comp the six texels of one place on the faces share their weights.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "prefilter/chart.glsl"
#include "prefilter/map.glsl"

layout(local_size_x = 4, local_size_y = 4) in;

layout(constant_id = 0) const int MAPS = 4;

layout(set = 0, binding = 0) uniform usamplerBuffer source; // margin = size: the neighbours whole
layout(set = 0, binding = 1, MAP_FORMAT) uniform writeonly image2DArray map_0;
layout(set = 0, binding = 2, MAP_FORMAT) uniform writeonly image2DArray map_1;
layout(set = 0, binding = 3, MAP_FORMAT) uniform writeonly image2DArray map_2;
layout(set = 0, binding = 4, MAP_FORMAT) uniform writeonly image2DArray map_3;

const int MOST_MAPS = 4;
const int FACES = 6;

layout(push_constant) uniform Params {
    vec4 exponents; // of the kernels
    uint source_size; // even
    uint size;        // of the maps
    float narrowing;  // variance that reading the maps adds in the face's plane, as in blur.comp
    float edge;       // as there
};

vec3 sums[MOST_MAPS * FACES];
float weight_sums[MOST_MAPS];
float narrow[MOST_MAPS]; // exponents less what reading blurs across the radial
vec3 centres[2];         // of kernels that are averaged: along the radial reading blurs less

// max(0, cosine)^n averaged over a texel's width: the lobe is not smooth at its edge.
float texel_power(float cosine, float n, float width) {
    float high = max(cosine + 0.5 * width, 0.0);
    float low = max(cosine - 0.5 * width, 0.0);
    float difference = (high > 0.0 ? exp2((n + 1.0) * log2(high)) : 0.0) -
                       (low > 0.0 ? exp2((n + 1.0) * log2(low)) : 0.0);
    return max(difference, 0.0) / ((n + 1.0) * width);
}

// Adds a pair of neighbouring texels, whose directions in the face's own frame are `taps`, to every
// face. `elements[i]` is where the pair lies for the faces of axis i: an opposite face is mirrored.
// `across` is 1 where the pair is on the opposite face, whose number differs in the last bit.
void add_pair(ChartPoint taps[2], ivec3 elements, bvec3 swapped, int across) {
    float width = 2.0 / float(source_size);
    float weights[2 * MOST_MAPS];
    for (int k = 0; k < 2; ++k) {
        for (int i = 0; i < MAPS; ++i) weights[2 * i + k] = 0.0;
        [[unroll]] for (int c = 0; c < 2; ++c) {
            vec3 difference = taps[k].direction - centres[c];
            float cosine = 1.0 - 0.5 * dot(difference, difference);
            for (int i = 0; i < MAPS; ++i) {
                weights[2 * i + k] += texel_power(cosine, narrow[i], width) * taps[k].density;
            }
        }
        for (int i = 0; i < MAPS; ++i) weight_sums[i] += weights[2 * i + k];
    }
    [[unroll]] for (int face = 0; face < FACES; ++face) {
        int face_size = int(9u * source_size * source_size / 2u);
        uvec4 pair = texelFetch(source, elements[face / 2] + (face ^ across) * face_size);
        if (swapped[face / 2]) pair = pair.zwxy;
        vec3 first = vec3(unpackHalf2x16(pair.x), unpackHalf2x16(pair.y).x);
        vec3 second = vec3(unpackHalf2x16(pair.z), unpackHalf2x16(pair.w).x);
        for (int i = 0; i < MAPS; ++i) {
            sums[i * FACES + face] += weights[2 * i] * first + weights[2 * i + 1] * second;
        }
    }
}

// The exponent whose lobe has the first eigenvalue of another before a blur of that variance.
float narrowed(float exponent, float variance) {
    float eigenvalue = (exponent + 1.0) / (exponent + 2.0) * (1.0 + variance);
    return (2.0 * eigenvalue - 1.0) / (1.0 - eigenvalue);
}

ChartPoint tap_at(ivec2 texel) {
    int n = int(source_size);
    ivec2 on_face = (texel + n) % n;
    float edges = 0.0;
    if (on_face.x == 0 || on_face.x == n - 1) edges += edge;
    if (on_face.y == 0 || on_face.y == n - 1) edges += edge;
    return chart_point((vec2(texel) + 0.5) * 2.0 / float(n) - 1.0, edges);
}

vec4 average_texel(int map, int face) {
    return map_texel(sums[map * FACES + face] / weight_sums[map]);
}

void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= size || at.y >= size) return;
    vec2 place = aim(map_place(at, size, size), narrowing);
    float square = 1.0 + dot(place, place);
    vec3 towards = vec3(place, 1.0);
    vec3 apart = radial_difference(place, narrowing);
    centres[0] = normalize(towards + apart);
    centres[1] = normalize(towards - apart);
    for (int i = 0; i < MAPS * FACES; ++i) sums[i] = vec3(0.0);
    for (int i = 0; i < MAPS; ++i) {
        narrow[i] = narrowed(exponents[i], narrowing / square);
        weight_sums[i] = 0.0;
    }

    int n = int(source_size);
    int stride = 3 * n;
    for (int y = -n; y < 2 * n; ++y) {
        bool across = y >= 0 && y < n; // rows beyond the face have no corners
        for (int x = across ? -n : 0; x < (across ? 2 * n : n); x += 2) {
            ChartPoint taps[2];
            for (int k = 0; k < 2; ++k) taps[k] = tap_at(ivec2(x + k, y));
            int element = ((y + n) * stride + x + n) / 2;
            add_pair(taps, ivec3(element), bvec3(false), 0);
        }
    }
    // The opposite face: seen from the faces of the X and Z axes it is mirrored left to right, from
    // those of the Y axis top to bottom. Face i's opposite is face i + 1 or i - 1.
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; x += 2) {
            ChartPoint taps[2];
            for (int k = 0; k < 2; ++k) {
                taps[k] = tap_at(ivec2(x + k, y));
                taps[k].direction.z = -taps[k].direction.z;
            }
            int left_right = ((y + n) * stride + 2 * n - 2 - x) / 2;
            int top_bottom = ((2 * n - 1 - y) * stride + x + n) / 2;
            add_pair(taps, ivec3(left_right, top_bottom, left_right),
                     bvec3(true, false, true), 1);
        }
    }

    [[unroll]] for (int face = 0; face < FACES; ++face) {
        ivec3 texel = ivec3(at, face);
        imageStore(map_0, texel, average_texel(0, face));
        if (MAPS > 1) imageStore(map_1, texel, average_texel(1, face));
        if (MAPS > 2) imageStore(map_2, texel, average_texel(2, face));
        if (MAPS > 3) imageStore(map_3, texel, average_texel(3, face));
    }
}
