// One step of the zonal chain: every texel of the target is the average of the source's texels under
// a kernel that is positive, ends at a chord, and is divided by the sum of its weights.
//
// By the cube's symmetry the six texels of one place on the faces share their weights, so an
// invocation does them all, for 2 x 2 neighbouring places. Fetches are 128 bits wide, two texels of
// halves: on a CPU device a fetch costs more than a weight.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

layout(constant_id = 0) const bool TO_IMAGE = false; // a map for shading, or a level of the chain

#define LEVEL_BINDING 1
#include "prefilter/store.glsl"
#include "prefilter/map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform usamplerBuffer source; // two texels an element
layout(set = 0, binding = 2, MAP_FORMAT) uniform writeonly image2DArray map;

layout(push_constant) uniform Params {
    uint source_size;
    uint source_margin; // even
    uint size;          // of the target, even
    uint margin;        // of the target
    uint across;        // of the target, see map_place()
    float sharpness;    // m of exp(-m (t + quadratic t^2 + t^3 / 3)), t the chord
    float quadratic;
    float last_chord; // where the kernel ends
    float narrowing;  // variance that other filters add in the face's plane, in its coordinates
    float drift;      // that they draw towards the face's centre, see aim()
    float edge;       // what texels along the faces' edges weigh too much, see chart_point()
};

const int PLACES = 4;
const int FACES = 6;
const float LOG2_E = 1.4426950408889634;

vec3 directions[PLACES];
vec3 radials[PLACES];       // unit tangents away from the face's centre
float sharp_around[PLACES]; // m across the radial
float sharp_along[PLACES];  // what m has more or less along it, halved
float weight_sums[PLACES];
vec3 sums[PLACES * FACES];

// The kernel's variance is 1 / sharpness less what other filters add: narrowing / r^4 along the
// radial and narrowing / r^2 across it, r the distance of the face's plane.
void place(int i, vec2 at) {
    at = aim(at, drift);
    float square = 1.0 + dot(at, at);
    directions[i] = vec3(at, 1.0) * inversesqrt(square);
    float off_centre = dot(at, at);
    radials[i] = off_centre > 0.0
                     ? vec3(at, -off_centre) * inversesqrt(off_centre * square)
                     : vec3(0.0);
    float around = 1.0 / (1.0 / sharpness - narrowing / square);
    float along = 1.0 / (1.0 / sharpness - narrowing / (square * square));
    sharp_around[i] = -LOG2_E * around;
    sharp_along[i] = -LOG2_E * 0.5 * (along - around);
    weight_sums[i] = 0.0;
}

float kernel(int i, ChartPoint tap) {
    vec3 difference = tap.direction - directions[i];
    float t = 0.5 * dot(difference, difference);
    float radial = dot(tap.direction, radials[i]);
    float power = sharp_around[i] * t * (1.0 + t * (quadratic + t * (1.0 / 3.0))) +
                  sharp_along[i] * radial * radial;
    return t <= last_chord ? exp2(power) * tap.density : 0.0;
}

// Interval of the chart's x at height `y` within `cosine` of `centre`; empty where x > y.
// On the line p + x q, |p + x q|^2 = d + x^2, the cap is (a + x b)^2 >= cosine^2 (d + x^2).
vec2 cap_on_line(float a, float b, float d, float cosine) {
    float denominator = cosine * cosine - b * b;
    float root = d * (b * b - cosine * cosine) + a * a;
    if (denominator <= 0.0) return vec2(-3.0, 3.0);
    if (root < 0.0) return vec2(3.0, -3.0);
    float middle = a * b / denominator;
    float half_width = cosine * sqrt(root) / denominator;
    return vec2(middle - half_width, middle + half_width);
}

vec2 cap_in_row(vec3 centre, float y, float cosine) {
    float on_face = clamp(y, -1.0, 1.0);
    float z = 1.0 - abs(y - on_face);
    vec2 reach = cap_on_line(on_face * centre.y + z * centre.z, centre.x,
                             on_face * on_face + z * z, cosine);
    // Beyond the face's edges the row goes on along the neighbours' depth.
    float d = 1.0 + on_face * on_face;
    if (reach.y > 1.0 && reach.x < reach.y) {
        vec2 depth = cap_on_line(centre.x + on_face * centre.y, centre.z, d, cosine);
        reach.y = depth.x < depth.y ? max(1.0, 2.0 - depth.x) : 1.0;
    }
    if (reach.x < -1.0 && reach.x < reach.y) {
        vec2 depth = cap_on_line(-centre.x + on_face * centre.y, centre.z, d, cosine);
        reach.x = depth.x < depth.y ? min(-1.0, depth.x - 2.0) : -1.0;
    }
    return reach;
}

void add_pair(int element, uint face_stride, float weights[2 * PLACES]) {
    [[unroll]] for (int face = 0; face < FACES; ++face) {
        uvec4 pair = texelFetch(source, element + face * int(face_stride));
        vec3 first = unpack_texel(pair.xy);
        vec3 second = unpack_texel(pair.zw);
        [[unroll]] for (int i = 0; i < PLACES; ++i) {
            sums[i * FACES + face] += weights[2 * i] * first + weights[2 * i + 1] * second;
        }
    }
}

void add_row(int y, vec2 reach) {
    float width = 2.0 / float(source_size);
    int margin_ = int(source_margin);
    int stride = int(source_size) + 2 * margin_;
    // Rows beyond the face end with it: nothing lies beyond a corner.
    int beyond = y < 0 || y >= int(source_size) ? 0 : margin_;
    int first = max(int(floor((reach.x + 1.0) / width)), -beyond) & ~1;
    int end = min(int(ceil((reach.y + 1.0) / width)), int(source_size) + beyond);
    int last = int(source_size) - 1;
    float row_edge = y == -1 || y == 0 || y == last || y == last + 1 ? edge : 0.0;
    for (int x = first; x < end; x += 2) {
        float weights[2 * PLACES];
        // Pairs are even: the edges run before and behind them.
        float edges[] = float[](x == 0 || x == last + 1 ? row_edge + edge : row_edge,
                                x == -2 || x == last - 1 ? row_edge + edge : row_edge);
        [[unroll]] for (int k = 0; k < 2; ++k) {
            ChartPoint tap = chart_point((vec2(x + k, y) + 0.5) * width - 1.0, edges[k]);
            [[unroll]] for (int i = 0; i < PLACES; ++i) {
                float weight = kernel(i, tap);
                weight_sums[i] += weight;
                weights[2 * i + k] = weight * UNPACKED;
            }
        }
        add_pair(((y + margin_) * stride + x + margin_) / 2, uint(stride * stride / 2), weights);
    }
}

void main() {
    uvec2 corner = 2u * gl_GlobalInvocationID.xy;
    if (corner.x >= size || corner.y >= size) return;
    [[unroll]] for (int i = 0; i < PLACES; ++i) {
        place(i, map_place(corner + uvec2(i & 1, i >> 1), size, across));
    }
    [[unroll]] for (int i = 0; i < PLACES * FACES; ++i) sums[i] = vec3(0.0);

    // One cap holds the caps of the four places.
    vec2 middle_place = aim(0.5 * (map_place(corner, size, across) + map_place(corner + 1u, size, across)), drift);
    vec3 centre = normalize(vec3(middle_place, 1.0));
    float reach = sqrt(2.0 * last_chord) + 1.42 / float(across); // chord lengths, no shorter than needed
    float cosine = 1.0 - 0.5 * reach * reach;

    float source_width = 2.0 / float(source_size);
    float height = reach * dot(vec3(centre.xy / centre.z, 1.0), vec3(centre.xy / centre.z, 1.0)) * 1.3;
    float middle = centre.y / centre.z;
    int first = max(int(floor((middle - height + 1.0) / source_width)), -int(source_margin));
    int end = min(int(ceil((middle + height + 1.0) / source_width)),
                  int(source_size + source_margin));
    for (int y = first; y < end; ++y) {
        vec2 row = cap_in_row(centre, (float(y) + 0.5) * source_width - 1.0, cosine);
        if (row.x <= row.y) add_row(y, row);
    }

    [[unroll]] for (int i = 0; i < PLACES; ++i) {
        float share = 1.0 / weight_sums[i];
        [[unroll]] for (int face = 0; face < FACES; ++face) {
            uvec3 texel = uvec3(corner + uvec2(i & 1, i >> 1), face);
            vec3 average = sums[i * FACES + face] * share;
            if (TO_IMAGE) {
                imageStore(map, ivec3(texel), map_texel(average));
            } else {
                store_texel(texel, size, margin, average);
            }
        }
    }
}
