// Panorama to cube map, area-true: each cube texel is the panorama integrated over the texel's
// solid angle.
//
// The overlap of a cube texel with a panorama texel follows from Green's theorem. With the measure
// m = 1 - sin(latitude), the solid angle of a region is the integral of m over longitude along its
// boundary; clamping m to a panorama row leaves the part in that row, and cutting the boundary at a
// column's meridians the part in that column (meridians themselves add nothing). Neighbours walk
// their common edge through the same nodes in opposite directions, so the overlaps of one panorama
// texel add up to its solid angle: no light is lost or doubled, however small its source.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/panorama.glsl"

layout(local_size_x = 64) in;

// Invocations that share one cube texel: 1, or all 64 where a texel covers many of the panorama's.
layout(constant_id = 0) const uint TEAM = 1;

layout(set = 0, binding = 0) uniform sampler2D panorama;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2DArray cube;

layout(push_constant) uniform Params {
    uint width;   // of the panorama
    uint height;
    uint size;    // of a cube face
    uint columns; // `width`, or a multiple of it that makes wedges narrow enough for the quadrature
};

// Gauss-Legendre nodes and weights on [0, 1].
const float NODES[3] = float[](0.1127016653792583, 0.5, 0.8872983346207417);
const float WEIGHTS[3] = float[](5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0);

// 1 - sin(latitude) of a point of the cube, without cancellation near the north pole.
float measure(vec3 p) {
    float distance = length(p);
    if (p.y <= 0.0) return 1.0 - p.y / distance;
    return dot(p.xz, p.xz) / (distance * (distance + p.y));
}

// The same of the panorama's edge above row `row`.
float row_measure(uint row) {
    float s = sin_turns(float(row) / float(4u * height));
    return 2.0 * s * s;
}

// Row, with its fraction, in which the measure lies.
float row_of(float m) {
    return angle_of(sqrt(m), sqrt(max(2.0 - m, 0.0))) * 2.0 / PI * float(height);
}

// Horizontal direction of the meridian before column `column`.
vec2 meridian(int column) {
    int wrapped = (column % int(columns) + int(columns)) % int(columns);
    float turns = 0.5 - float(wrapped) / float(columns);
    return vec2(sin_turns(turns), cos_turns(turns));
}

float cross_2d(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// The part of the segment from a to b, as an interval of its parameter, on the positive side of a
// line through the origin; `fa` and `fb` are the signed distances of its ends.
vec2 clip(vec2 interval, float fa, float fb) {
    if (fa < 0.0 && fb < 0.0) return vec2(1.0, 0.0);
    if (fa < 0.0) interval.x = max(interval.x, fa / (fa - fb));
    if (fb < 0.0) interval.y = min(interval.y, fa / (fa - fb));
    return interval;
}

// Radiance times solid angle, and solid angle, of the part of a cube texel that lies in every
// TEAM-th column of the panorama, from column number `lane` of those it touches.
vec4 integrate(uvec3 id, uint lane) {
    vec2 low = (vec2(2u * id.xy) - float(size)) / float(size);
    vec2 high = (vec2(2u * id.xy + 2u) - float(size)) / float(size);

    // The southern face is mirrored to the north, where the measure is accurate; its rows count
    // from the bottom then.
    bool mirrored = id.z == 3u;
    vec3 flip = vec3(1.0, mirrored ? -1.0 : 1.0, 1.0);
    vec3 corners[5];
    corners[0] = flip * cube_direction(id.z, low.x, low.y);
    corners[1] = flip * cube_direction(id.z, high.x, low.y);
    corners[2] = flip * cube_direction(id.z, high.x, high.y);
    corners[3] = flip * cube_direction(id.z, low.x, high.y);
    corners[4] = corners[0];

    // Extremes of the latitude lie at corners, or where a face coordinate is 0.
    vec2 middle = clamp(vec2(0.0), low, high);
    vec2 stops[3] = vec2[](low, middle, high);
    float least = 2.0;
    float most = 0.0;
    for (int i = 0; i < 9; ++i) {
        float m = measure(flip * cube_direction(id.z, stops[i % 3].x, stops[i / 3].y));
        least = min(least, m);
        most = max(most, m);
    }
    uint first_row = uint(clamp(floor(row_of(least) - 0.01), 0.0, float(height - 1u)));
    uint last_row = uint(clamp(floor(row_of(most) + 0.01), 0.0, float(height - 1u)));

    // Columns from the angles between the corners; all of them around a pole.
    float least_turned = 0.0;
    float most_turned = 0.0;
    bool on_polar_face = id.z == 2u || id.z == 3u;
    bool around_pole = on_polar_face && low.x < 0.0 && high.x > 0.0 && low.y < 0.0 && high.y > 0.0;
    int start = dot(corners[0].xz, corners[0].xz) == 0.0 ? 1 : 0; // a corner may lie on the pole
    for (int i = 1; i < 4; ++i) {
        vec2 from = corners[start].xz;
        vec2 to = corners[(start + i) % 4].xz;
        float turned = angle_of(cross_2d(to, from), dot(to, from));
        least_turned = min(least_turned, turned);
        most_turned = max(most_turned, turned);
    }
    float per_radian = float(columns) / (2.0 * PI);
    float start_column =
        float(columns) * 0.5 - angle_of(corners[start].x, corners[start].z) * per_radian;
    int first_column = int(floor(start_column - most_turned * per_radian - 0.01));
    int last_column = int(floor(start_column - least_turned * per_radian + 0.01));
    if (around_pole) {
        first_column = 0;
        last_column = int(columns) - 1;
    }

    vec4 sum = vec4(0.0);
    for (int column = first_column + int(lane); column <= last_column; column += int(TEAM)) {
        vec2 west = meridian(column);
        vec2 east = meridian(column + 1);
        float m[12];
        float longitude[12]; // what each node stands for, signed by the direction of the walk
        for (int edge = 0; edge < 4; ++edge) {
            vec3 a = corners[edge];
            vec3 b = corners[edge + 1];
            vec2 inside = clip(vec2(0.0, 1.0), cross_2d(west, a.xz), cross_2d(west, b.xz));
            inside = clip(inside, cross_2d(a.xz, east), cross_2d(b.xz, east));
            float span = max(inside.y - inside.x, 0.0) * cross_2d(a.xz, b.xz);
            for (int node = 0; node < 3; ++node) {
                vec3 p = mix(a, b, mix(inside.x, inside.y, NODES[node]));
                float square = dot(p.xz, p.xz);
                m[3 * edge + node] = measure(p);
                longitude[3 * edge + node] = span == 0.0 ? 0.0 : span * WEIGHTS[node] / square;
            }
        }

        int wrapped = (column % int(columns) + int(columns)) % int(columns);
        int x = wrapped / int(columns / width);
        vec4 column_sum = vec4(0.0);
        float above = row_measure(first_row);
        for (uint row = first_row; row <= last_row; ++row) {
            float below = row_measure(row + 1u);
            float overlap = 0.0;
            for (int i = 0; i < 12; ++i) {
                overlap += longitude[i] * (clamp(m[i], above, below) - above);
            }
            // Walks around mirrored texels run backwards; rounding must not make weights negative.
            overlap = max(mirrored ? -overlap : overlap, 0.0);
            above = below;
            int y = int(mirrored ? height - 1u - row : row);
            column_sum += overlap * vec4(texelFetch(panorama, ivec2(x, y), 0).rgb, 1.0);
        }
        sum += column_sum;
    }
    return sum;
}

shared vec4 sums[64];

void main() {
    uint lane = TEAM == 1u ? 0u : gl_LocalInvocationIndex;
    uvec3 id = TEAM == 1u ? gl_GlobalInvocationID : gl_WorkGroupID;
    vec4 sum = id.x < size ? integrate(id, lane) : vec4(0.0);
    if (TEAM > 1u) {
        sums[lane] = sum;
        for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
            barrier();
            if (lane < half_team) sums[lane] += sums[lane + half_team];
        }
        sum = sums[0];
    }
    if (lane == 0u && id.x < size) imageStore(cube, ivec3(id), vec4(sum.rgb / sum.a, 1.0));
}
