// Averages of an environment over Phong lobes, by summing every texel. A texel is constant radiance
// over its own solid angle, and the lobe is integrated over the texel's area: on a grid of cells (a
// texel, or a part of one where the lobe is narrow), each with a Gauss-Legendre rule. Cells that a
// horizon cuts are divided, and the cut is integrated in closed form. A workgroup answers a few
// queries; its invocations take the cells of a row in turns.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lobelia/cube.glsl"
#include "lobelia/lobe.glsl"

const uint TEAM = 64u;
const int QUERIES = 4; // that share each node and each texel
layout(local_size_x = 64) in;

layout(constant_id = 0) const bool CUBE = false;    // the source: a cube map, or a panorama
layout(constant_id = 1) const int ORDER = 1;        // nodes a side of a cell
layout(constant_id = 2) const bool CLIPPED = false; // the weight has the factor max(0, w.normal)

// Where a cell's first node lies, in cells from its middle.
const float FIRST_NODE = ORDER == 1 ? 0.0 : ORDER == 2 ? -0.28867513 : -0.38729833;

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
    float scale;         // of the weights, to keep their sum below 1
    float row_cull;      // cosine of the lobe's reach, widened by half a row
    float block_cull;    // the same, widened by half a block of TEAM cells
    uint columns;        // cells
    uint rows;           // cells of one layer
    uint repeat_columns; // cells in the width of one texel
    uint repeat_rows;    // cells in its height
    uint parts;          // a side, of a cell that a horizon cuts
    uint first_row;      // of this dispatch, counted through all layers
    uint row_count;
    uint first_query;
    uint end_query;
    uint last;         // 1: no rows are left after these
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

#include "exact_part.glsl"

// Cells near a horizon that matters are divided. A lobe that needs several nodes a cell is as good
// as 0 at its own.
const bool DIVIDES = ORDER == 1 || CLIPPED;
bool is_divided(Part cell, Query query) {
    if (ORDER == 1 && is_near_horizon(cell, query.axis.xyz)) return true;
    return CLIPPED && is_near_horizon(cell, query.normal.xyz);
}

float node_weight(Node node, Query query) {
    float weight = node.solid_angle *
                   chord_power(half_square_distance(node.direction, query.axis.xyz), exponent);
    return CLIPPED ? weight * max(dot(node.direction, query.normal.xyz), 0.0) : weight;
}

// The largest dot(direction, axis) of a row, or a bound above it.
float row_bound(uint layer, vec4 row, vec3 axis) {
    if (!CUBE) return row.x * axis.y + row.y * length(axis.xz);
    vec3 at_centre = cube_direction(layer, 0.0, row.x);
    float ahead = dot(at_centre, axis);
    float across = abs(dot(cube_direction(layer, 1.0, row.x) - at_centre, axis));
    float square = 1.0 + row.x * row.x;
    if (across * square < ahead) return length(vec2(ahead * inversesqrt(square), across));
    return (ahead + across) * inversesqrt(square + 1.0); // largest at an end
}

Query asked[QUERIES];
vec4 sums[QUERIES];

// Adds to the weights of a cell those of its parts, for the queries that divide it. One loop for
// all of them, since some devices go through a loop's body even where there is nothing to do.
void add_parts(uint layer, vec4 first_column, vec4 first_row, bool divided[QUERIES],
               inout float weights[QUERIES]) {
    uint count = parts * parts;
    bool any_divided = divided[0] || divided[1] || divided[2] || divided[3];
    for (uint i = any_divided ? 0u : QUERIES * count; i < QUERIES * count; ++i) {
        int q = int(i / count);
        if (!divided[q]) {
            i += count - 1u;
            continue;
        }
        uint index = i % count;
        vec2 at = (vec2(index % parts, index / parts) + 0.5) / float(parts) - 0.5;
        Part part = part_of(layer, first_column, first_row, at, float(parts));
        weights[q] += part_weight(part, asked[q]);
    }
}

// The integral of each query's weight over one cell.
void cell_weights(uint layer, uint row, uint column, out float weights[QUERIES]) {
    vec4 first_column = column_node(column, 0);
    vec4 first_row = row_node(row, 0);
    bool divided[QUERIES];
    for (int q = 0; q < QUERIES; ++q) {
        divided[q] = false;
        weights[q] = 0.0;
    }
    if (DIVIDES) {
        Part cell = part_of(layer, first_column, first_row, vec2(0.0), 1.0);
        for (int q = 0; q < QUERIES; ++q) {
            divided[q] = is_divided(cell, asked[q]);
            if (ORDER == 1 && !divided[q]) weights[q] = part_weight(cell, asked[q]);
        }
        add_parts(layer, first_column, first_row, divided, weights);
    }
    if (ORDER == 1) return;
    for (int j = 0; j < ORDER; ++j) {
        vec4 down = row_node(row, j);
        for (int i = 0; i < ORDER; ++i) {
            Node node = node_at(layer, column_node(column, i), down);
            for (int q = 0; q < QUERIES; ++q) {
                if (!divided[q]) weights[q] += node_weight(node, asked[q]);
            }
        }
    }
}

// What some lobe reaches is looked for in loops of their own: some devices go through the body of a
// branch that is not taken.

// The first row from i on.
uint next_row(uint i) {
    for (; i < first_row + row_count; ++i) {
        vec4 middle = row_node(i % rows, 0);
        float bound = -1.0;
        for (int q = 0; q < QUERIES; ++q)
            bound = max(bound, row_bound(i / rows, middle, asked[q].axis.xyz));
        if (bound >= row_cull) break;
    }
    return i;
}

// The first TEAM columns of a row from `block` on.
uint next_block(uint layer, vec4 row, uint block) {
    for (; block < columns; block += TEAM) {
        vec4 middle = column_node(min(block + TEAM / 2u, columns - 1u), 0);
        vec3 centre = node_at(layer, middle, row).direction;
        float nearest = -1.0;
        for (int q = 0; q < QUERIES; ++q) nearest = max(nearest, dot(centre, asked[q].axis.xyz));
        if (nearest >= block_cull) break;
    }
    return block;
}

// Adds what the invocation's cells of one row give to each query.
void add_row(uint layer, uint row, uint lane) {
    vec4 row_sums[QUERIES];
    for (int q = 0; q < QUERIES; ++q) row_sums[q] = vec4(0.0);

    vec4 middle = row_node(row, 0);
    for (uint block = next_block(layer, middle, 0u); block < columns;
         block = next_block(layer, middle, block + TEAM)) {
        uint column = block + lane;
        if (column >= columns) continue;

        float weights[QUERIES];
        cell_weights(layer, row, column, weights);
        ivec3 texel = ivec3(column / repeat_columns, row / repeat_rows, layer);
        vec3 light = texelFetch(source, texel, 0).rgb;
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

const float LARGEST = 3.4028235e38;

// The average and the weight's integral. Rounding must not take the largest number to infinity.
vec4 average_of(vec4 sum) {
    if (sum.a == 0.0) return vec4(0.0);
    vec3 half_average = min(0.5 * sum.rgb / sum.a, vec3(0.5 * LARGEST));
    return vec4(2.0 * half_average, sum.a / scale);
}

void main() {
    uint lane = gl_LocalInvocationIndex;
    uint first = first_query + gl_WorkGroupID.x * uint(QUERIES);
    for (int q = 0; q < QUERIES; ++q) {
        asked[q] = queries[min(first + uint(q), end_query - 1u)];
        sums[q] = vec4(0.0);
    }

    for (uint i = next_row(first_row); i < first_row + row_count; i = next_row(i + 1u))
        add_row(i / rows, i % rows, lane);

    for (int q = 0; q < QUERIES; ++q) {
        vec4 sum = team_sum(sums[q], lane);
        uint index = first + uint(q);
        if (lane > 0u || index >= end_query) continue;
        if (first_row > 0u) sum += results[index];
        results[index] = last == 1u ? average_of(sum) : sum;
    }
}
