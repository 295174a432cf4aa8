// Panorama to cube map, area-true: each cube texel is the panorama integrated over the texel's
// solid angle.
//
// The overlap of a cube texel with a panorama texel follows from Green's theorem. With the measure
// m = 1 - sin(latitude), the solid angle of a region is the integral of m over longitude along its
// boundary; clamping m to a panorama row leaves the part in that row, and cutting the boundary at a
// column's meridians the part in that column (meridians themselves add nothing). Between two
// meridians m is taken as linear in longitude, with its exact mean, so that a row's edge cuts it
// where it does. Neighbours walk their common edge through the same points in opposite directions,
// so the overlaps of one panorama texel add up to its solid angle: no light is lost or doubled,
// however small its source.
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
    uint columns; // `width`, or a multiple of it that makes m all but linear across one
};

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

// How much the measure grows across a row: the difference of the above without its cancellation.
float row_height(uint row) {
    return 2.0 * sin_turns(float(2u * row + 1u) / float(4u * height)) *
           sin_turns(1.0 / float(4u * height));
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

// A piece of boundary between two meridians: the measure at its ends, and the longitude it covers,
// signed by the direction of the walk.
struct Piece {
    float from;
    float to;
    float longitude;
};

// The part of the edge from a to b that `inside` tells, as an interval of its parameter.
Piece piece_of(vec3 a, vec3 b, vec2 inside) {
    float span = max(inside.y - inside.x, 0.0) * cross_2d(a.xz, b.xz);
    if (span == 0.0) return Piece(0.0, 0.0, 0.0); // empty, or along a meridian
    vec3 start = mix(a, b, inside.x);
    vec3 middle = mix(a, b, 0.5 * (inside.x + inside.y));
    vec3 end = mix(a, b, inside.y);
    vec3 m = vec3(measure(start), measure(middle), measure(end));
    vec3 turn = vec3(1.0, 4.0, 1.0) / 6.0 / // Simpson's rule
                vec3(dot(start.xz, start.xz), dot(middle.xz, middle.xz), dot(end.xz, end.xz));
    float turned = turn.x + turn.y + turn.z;
    float bend = dot(turn, m) / turned - 0.5 * (m.x + m.z);
    return Piece(m.x + bend, m.z + bend, span * turned);
}

// What a piece cuts off between the measures `above` and `below`: mean height times longitude.
float overlap_of(Piece piece, float above, float below) {
    float low = min(piece.from, piece.to);
    float high = max(piece.from, piece.to);
    float low_inside = clamp(low, above, below);
    float high_inside = clamp(high, above, below);
    if (low_inside == high_inside) return piece.longitude * (low_inside - above);
    float inside = (high_inside - low_inside) * (0.5 * (low_inside + high_inside) - above);
    return piece.longitude * (inside + (high - high_inside) * (below - above)) / (high - low);
}

// A quarter of radiance times solid angle and of solid angle, so that no sum of finite radiance is
// infinite; and between which radiances the average lies.
struct Light {
    vec4 sum;
    vec3 least;
    vec3 most;
};

Light add(Light a, Light b) {
    return Light(a.sum + b.sum, min(a.least, b.least), max(a.most, b.most));
}

// The part of a cube texel that lies in every TEAM-th column of the panorama, from column number
// `lane` of those it touches.
Light integrate(uvec3 id, uint lane) {
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

    Light light = Light(vec4(0.0), vec3(3.4028235e38), vec3(0.0));
    for (int column = first_column + int(lane); column <= last_column; column += int(TEAM)) {
        vec2 west = meridian(column);
        vec2 east = meridian(column + 1);
        Piece pieces[4];
        for (int edge = 0; edge < 4; ++edge) {
            vec3 a = corners[edge];
            vec3 b = corners[edge + 1];
            vec2 inside = clip(vec2(0.0, 1.0), cross_2d(west, a.xz), cross_2d(west, b.xz));
            inside = clip(inside, cross_2d(a.xz, east), cross_2d(b.xz, east));
            pieces[edge] = piece_of(a, b, inside);
        }

        int wrapped = (column % int(columns) + int(columns)) % int(columns);
        int x = wrapped / int(columns / width);
        vec4 column_sum = vec4(0.0);
        float above = row_measure(first_row);
        for (uint row = first_row; row <= last_row; ++row) {
            float below = row_measure(row + 1u);
            float overlap = 0.0;
            for (int edge = 0; edge < 4; ++edge) overlap += overlap_of(pieces[edge], above, below);
            // Walks around mirrored texels run backwards; rounding must not make weights negative.
            overlap = max(mirrored ? -overlap : overlap, 0.0) * 0.25 * row_height(row) /
                      (below - above);
            above = below;
            if (overlap == 0.0) continue;
            int y = int(mirrored ? height - 1u - row : row);
            vec3 radiance = texelFetch(panorama, ivec2(x, y), 0).rgb;
            column_sum += overlap * vec4(radiance, 1.0);
            light.least = min(light.least, radiance);
            light.most = max(light.most, radiance);
        }
        light.sum += column_sum;
    }
    return light;
}

shared Light lights[64];

void main() {
    uint lane = TEAM == 1u ? 0u : gl_LocalInvocationIndex;
    uvec3 id = TEAM == 1u ? gl_GlobalInvocationID : gl_WorkGroupID;
    if (TEAM == 1u && id.x >= size) return;
    Light light = integrate(id, lane);
    if (TEAM > 1u) {
        lights[lane] = light;
        for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
            barrier();
            if (lane < half_team) lights[lane] = add(lights[lane], lights[lane + half_team]);
        }
        light = lights[0];
    }
    vec3 average = clamp(light.sum.rgb / light.sum.a, light.least, light.most);
    if (lane == 0u) imageStore(cube, ivec3(id), vec4(average, 1.0));
}
