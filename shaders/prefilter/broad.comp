// Maps of low exponents: direct sums over every texel of a small level, up to four maps at once. As
// in blur.comp the six texels of one place on the faces share their weights.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "lobelia/lobe.glsl"
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
const float LOG2_E = 1.4426950408889634;

layout(push_constant) uniform Params {
    vec4 exponents; // of the kernels
    uint source_size; // even
    uint size;        // of the maps
    float narrowing;  // variance that reading the maps adds in the face's plane, as in blur.comp
};

vec3 sums[MOST_MAPS * FACES];
float weight_sums[MOST_MAPS];
float around[MOST_MAPS]; // exponent across the radial
float along[MOST_MAPS];  // what the exponent has more or less along it, times log2(e) / 2

// max(0, cosine)^n over one texel: where the lobe's edge cuts it, averaged over its width.
float texel_power(float chord, float log2_cosine, float n, float width) {
    float cosine = 1.0 - chord;
    if (n >= 2.0 || abs(cosine) > width) return chord < 1.0 ? exp2(n * log2_cosine) : 0.0;
    float high = max(cosine + 0.5 * width, 0.0);
    float low = max(cosine - 0.5 * width, 0.0);
    float difference = (high > 0.0 ? exp2((n + 1.0) * log2(high)) : 0.0) -
                       (low > 0.0 ? exp2((n + 1.0) * log2(low)) : 0.0);
    return max(difference, 0.0) / ((n + 1.0) * width);
}

// Adds a pair of neighbouring texels, whose directions in the face's own frame are `taps`, to every
// face. `elements[i]` is where the pair lies for the faces of axis i: an opposite face is mirrored.
// `across` is 1 where the pair is on the opposite face, whose number differs in the last bit.
void add_pair(vec3 centre, vec3 radial, ChartPoint taps[2], ivec3 elements, bvec3 swapped, int across) {
    float width = 2.0 / float(source_size);
    float weights[2 * MOST_MAPS];
    for (int k = 0; k < 2; ++k) {
        vec3 difference = taps[k].direction - centre;
        float chord = 0.5 * dot(difference, difference);
        float log2_cosine = chord < 1.0 ? log2_one_minus(chord) : 0.0;
        float off = dot(taps[k].direction, radial);
        for (int i = 0; i < MAPS; ++i) {
            float weight = texel_power(chord, log2_cosine, around[i], width) * taps[k].density;
            weights[2 * i + k] = weight * exp2(-along[i] * off * off);
            weight_sums[i] += weights[2 * i + k];
        }
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

vec4 average_texel(int map, int face) {
    return map_texel(sums[map * FACES + face] / weight_sums[map]);
}

void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= size || at.y >= size) return;
    vec2 place = (vec2(at) + 0.5) * 2.0 / float(size) - 1.0;
    vec3 centre = normalize(vec3(place, 1.0));
    float off_centre = dot(place, place);
    float square = 1.0 + off_centre;
    vec3 radial = off_centre > 0.0 ? vec3(place, -off_centre) * inversesqrt(off_centre * square)
                                   : vec3(0.0);
    for (int i = 0; i < MAPS * FACES; ++i) sums[i] = vec3(0.0);
    for (int i = 0; i < MAPS; ++i) {
        float n = exponents[i];
        around[i] = n / (1.0 - n * narrowing / square);
        along[i] = 0.5 * LOG2_E * (n / (1.0 - n * narrowing / (square * square)) - around[i]);
        weight_sums[i] = 0.0;
    }

    int n = int(source_size);
    int stride = 3 * n;
    float width = 2.0 / float(n);
    for (int y = -n; y < 2 * n; ++y) {
        bool across = y >= 0 && y < n; // rows beyond the face have no corners
        for (int x = across ? -n : 0; x < (across ? 2 * n : n); x += 2) {
            ChartPoint taps[2];
            for (int k = 0; k < 2; ++k) taps[k] = chart_point((vec2(x + k, y) + 0.5) * width - 1.0);
            int element = ((y + n) * stride + x + n) / 2;
            add_pair(centre, radial, taps, ivec3(element), bvec3(false), 0);
        }
    }
    // The opposite face: seen from the faces of the X and Z axes it is mirrored left to right, from
    // those of the Y axis top to bottom. Face i's opposite is face i + 1 or i - 1.
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; x += 2) {
            ChartPoint taps[2];
            for (int k = 0; k < 2; ++k) {
                taps[k] = chart_point((vec2(x + k, y) + 0.5) * width - 1.0);
                taps[k].direction.z = -taps[k].direction.z;
            }
            int left_right = ((y + n) * stride + 2 * n - 2 - x) / 2;
            int top_bottom = ((2 * n - 1 - y) * stride + x + n) / 2;
            add_pair(centre, radial, taps, ivec3(left_right, top_bottom, left_right),
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
