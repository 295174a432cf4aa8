// Averages of an environment over Phong lobes, by summing every texel. A texel is constant radiance
// over its own solid angle, and the lobe is integrated over the texel's area: on a grid of cells (a
// texel, or a part of one where the lobe is narrow), each with a Gauss-Legendre rule. A workgroup
// answers a few queries; its invocations take the cells of a row in turns.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/lobe.glsl"

const uint TEAM = 64u;
const int QUERIES = 4; // that share each node and each texel
layout(local_size_x = 64) in;

layout(constant_id = 0) const bool CUBE = false; // the source: a cube map, or a panorama
layout(constant_id = 1) const int ORDER = 1;     // nodes a side of a cell

struct Query {
    vec4 axis;
    vec4 normal;
};

layout(set = 0, binding = 0) uniform sampler2DArray source; // one layer, or six faces
layout(set = 0, binding = 1, std430) readonly buffer Queries { Query queries[]; };
layout(set = 0, binding = 2, std430) buffer Results { vec4 results[]; };
// ORDER nodes for each column, then for each row: of a panorama sine and cosine of longitude or
// latitude, of a cube the face coordinate u or v; then in z the node's share of the cell.
layout(set = 0, binding = 3, std430) readonly buffer Nodes { vec4 nodes[]; };

layout(push_constant) uniform Params {
    float exponent;
    float scale;      // of the weights, to keep their sum below 1
    float row_cull;   // cosine of the lobe's reach, widened by half a row
    float block_cull; // the same, widened by half a block of TEAM cells
    uint columns;     // cells
    uint rows;        // cells of one layer
    uint repeat;      // cells a side of one texel
    uint clipped;     // 1: the weight has the factor max(0, w.normal)
    uint first_row;   // of this dispatch, counted through all layers
    uint row_count;
    uint first_query;
    uint end_query;
    uint last; // 1: no rows are left after these
    float cell_width;  // longitude or u
    float cell_height; // latitude or v
};

vec4 column_node(uint column, int node) { return nodes[column * uint(ORDER) + uint(node)]; }
vec4 row_node(uint row, int node) { return nodes[(columns + row) * uint(ORDER) + uint(node)]; }

struct Node {
    vec3 direction;
    float solid_angle;
};

Node node_at(uint layer, vec4 column, vec4 row) {
    if (CUBE) {
        float shrink = inversesqrt(1.0 + column.x * column.x + row.x * row.x);
        return Node(cube_direction(layer, column.x, row.x) * shrink,
                    column.z * row.z * shrink * shrink * shrink);
    }
    return Node(vec3(column.x * row.y, row.x, column.y * row.y), column.z * row.z);
}

// How much dot(direction, axis) changes across a cell: along the columns and along the rows.
vec2 slopes(uint layer, vec4 column, vec4 row, vec3 direction, vec3 axis) {
    if (CUBE) {
        float shrink = inversesqrt(1.0 + column.x * column.x + row.x * row.x);
        vec3 centre = cube_direction(layer, 0.0, 0.0);
        vec3 across = cube_direction(layer, 1.0, 0.0) - centre;
        vec3 down = cube_direction(layer, 0.0, 1.0) - centre;
        float along = dot(direction, axis);
        return shrink * abs(vec2(dot(across, axis) - dot(across, direction) * along,
                                 dot(down, axis) - dot(down, direction) * along)) *
               vec2(cell_width, cell_height);
    }
    float level = column.x * axis.x + column.y * axis.z;
    return abs(vec2(row.y * (column.y * axis.x - column.x * axis.z),
                    row.y * axis.y - row.x * level)) *
           vec2(cell_width, cell_height);
}

// max(0, cosine)^n averaged over a cell near the plane cosine = 0, with the cosine taken as linear
// across it: the second antiderivative at the cell's four corners. Slopes too different to divide by
// are brought within a factor of 20, which moves the average in second order.
float cut_power(float cosine, vec2 slope, float n) {
    float steep = max(slope.x, slope.y);
    float gentle = max(min(slope.x, slope.y), 0.05 * steep);
    vec4 corner = vec4(cosine) + 0.5 * vec4(steep + gentle, steep - gentle, gentle - steep,
                                            -steep - gentle);
    vec4 power = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        if (corner[i] > 0.0) power[i] = exp2((n + 2.0) * log2(corner[i]));
    }
    float difference = power.x - power.y - power.z + power.w;
    return max(difference, 0.0) / ((n + 1.0) * (n + 2.0) * steep * gentle);
}

// max(0, dot(direction, axis))^n averaged over a cell with one node: near the horizon as above, to
// second order elsewhere.
float cell_power(uint layer, vec4 column, vec4 row, vec3 direction, vec3 axis, float n) {
    float chord = half_square_distance(direction, axis);
    float cosine = 1.0 - chord;
    float power = chord_power(chord, n);
    if (abs(cosine) > 8.0 * (cell_width + cell_height)) return power;
    vec2 slope = slopes(layer, column, row, direction, axis);
    if (abs(cosine) < 1.5 * (slope.x + slope.y)) return cut_power(cosine, slope, n);
    return power * (1.0 + n * (n - 1.0) / 24.0 * dot(slope, slope) / (cosine * cosine));
}

float weight(uint layer, vec4 column, vec4 row, Node node, Query query) {
    if (ORDER == 1) {
        float value = cell_power(layer, column, row, node.direction, query.axis.xyz, exponent);
        if (clipped == 0u) return value;
        return value * cell_power(layer, column, row, node.direction, query.normal.xyz, 1.0);
    }
    float value = chord_power(half_square_distance(node.direction, query.axis.xyz), exponent);
    return clipped == 0u ? value : value * max(dot(node.direction, query.normal.xyz), 0.0);
}

// The largest dot(direction, axis) of a row, or a bound above it.
float row_bound(uint layer, vec4 row, vec3 axis) {
    if (CUBE) {
        vec3 at_centre = cube_direction(layer, 0.0, row.x);
        vec3 across = cube_direction(layer, 1.0, row.x) - at_centre;
        float ahead = dot(at_centre, axis) * inversesqrt(1.0 + row.x * row.x);
        return length(vec2(ahead, dot(across, axis)));
    }
    return row.x * axis.y + row.y * length(axis.xz);
}

Query asked[QUERIES];
vec4 sums[QUERIES];

// Adds what the invocation's cells of one row give to each query.
void add_row(uint layer, uint row, uint lane) {
    vec4 row_sums[QUERIES];
    for (int q = 0; q < QUERIES; ++q) row_sums[q] = vec4(0.0);

    for (uint block = 0u; block < columns; block += TEAM) {
        vec4 middle = column_node(min(block + TEAM / 2u, columns - 1u), 0);
        vec3 centre = node_at(layer, middle, row_node(row, 0)).direction;
        float nearest = -1.0;
        for (int q = 0; q < QUERIES; ++q) nearest = max(nearest, dot(centre, asked[q].axis.xyz));
        uint column = block + lane;
        if (nearest < block_cull || column >= columns) continue;

        float weights[QUERIES];
        for (int q = 0; q < QUERIES; ++q) weights[q] = 0.0;
        for (int j = 0; j < ORDER; ++j) {
            vec4 down = row_node(row, j);
            for (int i = 0; i < ORDER; ++i) {
                vec4 across = column_node(column, i);
                Node node = node_at(layer, across, down);
                for (int q = 0; q < QUERIES; ++q) {
                    weights[q] += node.solid_angle * weight(layer, across, down, node, asked[q]);
                }
            }
        }
        vec3 light = texelFetch(source, ivec3(column / repeat, row / repeat, layer), 0).rgb;
        for (int q = 0; q < QUERIES; ++q) row_sums[q] += scale * weights[q] * vec4(light, 1.0);
    }
    for (int q = 0; q < QUERIES; ++q) sums[q] += row_sums[q];
}

shared vec4 team_sums[TEAM];

vec4 team_sum(vec4 sum, uint lane) {
    barrier(); // the sum before has been read
    team_sums[lane] = sum;
    for (uint half_team = TEAM / 2u; half_team > 0u; half_team /= 2u) {
        barrier();
        if (lane < half_team) team_sums[lane] += team_sums[lane + half_team];
    }
    barrier();
    return team_sums[0];
}

void main() {
    uint lane = gl_LocalInvocationIndex;
    uint first = first_query + gl_WorkGroupID.x * uint(QUERIES);
    for (int q = 0; q < QUERIES; ++q) {
        asked[q] = queries[min(first + uint(q), end_query - 1u)];
        sums[q] = vec4(0.0);
    }

    for (uint i = first_row; i < first_row + row_count; ++i) {
        uint layer = i / rows;
        uint row = i % rows;
        float bound = -1.0;
        for (int q = 0; q < QUERIES; ++q) {
            bound = max(bound, row_bound(layer, row_node(row, 0), asked[q].axis.xyz));
        }
        if (bound >= row_cull) add_row(layer, row, lane);
    }

    for (int q = 0; q < QUERIES; ++q) {
        vec4 sum = team_sum(sums[q], lane);
        uint index = first + uint(q);
        if (lane > 0u || index >= end_query) continue;
        if (first_row > 0u) sum += results[index];
        if (last == 1u) sum = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / scale) : vec4(0.0);
        results[index] = sum;
    }
}
