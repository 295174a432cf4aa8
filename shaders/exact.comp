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

layout(constant_id = 0) const bool CUBE = false; // the source: a cube map, or a panorama
layout(constant_id = 1) const int ORDER = 1;     // nodes a side of a cell

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
    float scale;      // of the weights, to keep their sum below 1
    float row_cull;   // cosine of the lobe's reach, widened by half a row
    float block_cull; // the same, widened by half a block of TEAM cells
    uint columns;     // cells
    uint rows;        // cells of one layer
    uint repeat_columns; // cells in the width of one texel
    uint repeat_rows;    // cells in its height
    uint parts;          // a side, of a cell that a horizon cuts
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

// A cell, or one of the equal parts it is divided into: its middle, what the direction changes by
// across it along the columns and along the rows, and its solid angle. `bend` is of second order:
// the direction's second derivatives, and twice its first ones times those of the solid angle.
struct Part {
    vec3 direction;
    vec3 across;
    vec3 down;
    vec3 bend;
    float solid_angle;
};

// The coordinate at `offset` cells of size `size` from the cell's middle.
vec2 coordinate(vec4 first_node, float offset, float size) {
    offset -= FIRST_NODE;
    if (CUBE) return vec2(first_node.x + offset * size, 0.0);
    float angle = offset * size; // at most 0.3; longitude and latitude fall as it grows
    float q = angle * angle;
    float sine = angle * (1.0 - q / 6.0 * (1.0 - q / 20.0));
    float cosine = 1.0 - q / 2.0 * (1.0 - q / 12.0);
    return vec2(first_node.x * cosine - first_node.y * sine,
                first_node.y * cosine + first_node.x * sine);
}

// The part in the middle of the offset `at`, as large as 1 / `count` of the cell each way.
Part part_of(uint layer, vec4 first_column, vec4 first_row, vec2 at, float count) {
    vec2 column = coordinate(first_column, at.x, cell_width);
    vec2 row = coordinate(first_row, at.y, cell_height);
    vec2 size = vec2(cell_width, cell_height) / count;
    Part part;
    if (CUBE) {
        float shrink = inversesqrt(1.0 + column.x * column.x + row.x * row.x);
        vec3 centre = cube_direction(layer, 0.0, 0.0);
        vec3 right = cube_direction(layer, 1.0, 0.0) - centre;
        vec3 below = cube_direction(layer, 0.0, 1.0) - centre;
        vec2 lean = shrink * vec2(column.x, row.x);
        part.direction = shrink * (centre + column.x * right + row.x * below);
        part.across = size.x * shrink * (right - lean.x * part.direction);
        part.down = size.y * shrink * (below - lean.y * part.direction);
        part.bend = -8.0 * shrink * (lean.x * size.x * part.across + lean.y * size.y * part.down) -
                    (dot(part.across, part.across) + dot(part.down, part.down)) * part.direction;
        part.solid_angle = size.x * size.y * shrink * shrink * shrink;
    } else {
        part.direction = vec3(column.x * row.y, row.x, column.y * row.y);
        part.across = size.x * row.y * vec3(-column.y, 0.0, column.x);
        part.down = size.y * vec3(row.x * column.x, -row.y, row.x * column.y);
        part.bend = vec3(0.0, size.x * size.x * row.x, 0.0) - dot(size, size) * part.direction +
                    2.0 * size.y * row.x / row.y * part.down;
        part.solid_angle = size.x * size.y * row.y;
    }
    return part;
}

// How much dot(direction, axis) changes across a part.
vec2 slopes(Part part, vec3 axis) { return vec2(dot(part.across, axis), dot(part.down, axis)); }

// Whether the plane dot(direction, axis) = 0 cuts a part or is too near for a series.
bool is_near_horizon(Part part, vec3 axis) {
    vec2 slope = abs(slopes(part, axis));
    return abs(dot(part.direction, axis)) < 1.5 * (slope.x + slope.y);
}

// max(0, x)^exponent for each x.
vec4 positive_power(vec4 x, float exponent) {
    vec4 power = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        if (x[i] > 0.0) power[i] = exp2(exponent * log2(x[i]));
    }
    return power;
}

// max(0, cosine)^n averaged over a part near the plane cosine = 0, with the cosine taken as linear
// across it: the second antiderivative at its four corners, or, where one slope is too gentle to
// divide by, the first one at the ends of two lines. In units of the largest cosine, so that no
// exponent overflows.
float cut_power(float cosine, vec2 slope, float n) {
    float top = cosine + 0.5 * (slope.x + slope.y);
    if (top <= 0.0) return 0.0;
    float steep = max(slope.x, slope.y) / top;
    float gentle = min(slope.x, slope.y) / top;
    float average;
    if (gentle < 0.05 * steep) {
        vec2 line = vec2(-0.28867513, 0.28867513) * gentle;
        vec4 ends = cosine / top + vec4(line + 0.5 * steep, line - 0.5 * steep);
        vec4 power = positive_power(ends, n + 1.0);
        average = 0.5 * (power.x + power.y - power.z - power.w) / ((n + 1.0) * steep);
    } else {
        vec4 corners = vec4(1.0, 1.0 - gentle, 1.0 - steep, 1.0 - steep - gentle);
        vec4 power = positive_power(corners, n + 2.0);
        average = (power.x - power.y - power.z + power.w) /
                  ((n + 1.0) * (n + 2.0) * steep * gentle);
    }
    return max(average, 0.0) * exp2(n * log2(top));
}

// max(0, dot(direction, axis))^n averaged over a part: near the horizon as above, to second order
// elsewhere.
float part_power(Part part, vec3 axis, float n) {
    float cosine = dot(part.direction, axis);
    vec2 slope = slopes(part, axis);
    if (is_near_horizon(part, axis)) return cut_power(cosine, abs(slope), n);
    if (cosine < 0.0) return 0.0;
    float second = (n - 1.0) * dot(slope, slope) / (cosine * cosine) + dot(part.bend, axis) / cosine;
    return chord_power(half_square_distance(part.direction, axis), n) * (1.0 + n / 24.0 * second);
}

float part_weight(Part part, Query query) {
    float weight = part.solid_angle * part_power(part, query.axis.xyz, exponent);
    if (clipped == 0u) return weight;
    weight *= part_power(part, query.normal.xyz, 1.0);
    if (is_near_horizon(part, query.axis.xyz) || is_near_horizon(part, query.normal.xyz))
        return weight;
    // the two powers change together
    return weight * (1.0 + exponent / 12.0 *
                               dot(slopes(part, query.axis.xyz), slopes(part, query.normal.xyz)) /
                               (dot(part.direction, query.axis.xyz) *
                                dot(part.direction, query.normal.xyz)));
}

// Cells near a horizon that matters are divided. A lobe that needs several nodes a cell is as good
// as 0 at its own.
bool is_divided(Part cell, Query query) {
    if (ORDER == 1 && is_near_horizon(cell, query.axis.xyz)) return true;
    return clipped == 1u && is_near_horizon(cell, query.normal.xyz);
}

float divided_weight(uint layer, vec4 first_column, vec4 first_row, Query query) {
    float weight = 0.0;
    for (uint i = 0u; i < parts * parts; ++i) {
        vec2 at = (vec2(i % parts, i / parts) + 0.5) / float(parts) - 0.5;
        weight += part_weight(part_of(layer, first_column, first_row, at, float(parts)), query);
    }
    return weight;
}

float node_weight(Node node, Query query) {
    float weight = node.solid_angle *
                   chord_power(half_square_distance(node.direction, query.axis.xyz), exponent);
    return clipped == 0u ? weight : weight * max(dot(node.direction, query.normal.xyz), 0.0);
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

// The integral of each query's weight over one cell.
void cell_weights(uint layer, uint row, uint column, out float weights[QUERIES]) {
    vec4 first_column = column_node(column, 0);
    vec4 first_row = row_node(row, 0);
    Part cell = part_of(layer, first_column, first_row, vec2(0.0), 1.0);
    bool divided[QUERIES];
    for (int q = 0; q < QUERIES; ++q) {
        divided[q] = is_divided(cell, asked[q]);
        weights[q] = 0.0;
        if (divided[q]) weights[q] = divided_weight(layer, first_column, first_row, asked[q]);
        if (ORDER == 1 && !divided[q]) weights[q] = part_weight(cell, asked[q]);
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
        cell_weights(layer, row, column, weights);
        vec3 light = texelFetch(source, ivec3(column / repeat_columns, row / repeat_rows, layer), 0).rgb;
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
