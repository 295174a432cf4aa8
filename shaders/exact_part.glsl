// The integral of a query's weight over a part of an environment: a cell of exact.comp's grid, or
// what a cell is divided into. To second order, and where a horizon cuts the part in closed form.
// For exact.comp, whose constants and parameters it uses.
#ifndef LOBELIA_EXACT_PART_GLSL
#define LOBELIA_EXACT_PART_GLSL

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
    float angle = offset * size; // below 0.05; longitude and latitude fall as it grows
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
        float second = 15.0 * dot(lean * lean, size * size) - 3.0 * dot(size, size);
        part.solid_angle = size.x * size.y * shrink * shrink * shrink *
                           (1.0 + shrink * shrink / 24.0 * second);
    } else {
        part.direction = vec3(column.x * row.y, row.x, column.y * row.y);
        part.across = size.x * row.y * vec3(-column.y, 0.0, column.x);
        part.down = size.y * vec3(row.x * column.x, -row.y, row.x * column.y);
        part.bend = vec3(0.0, size.x * size.x * row.x, 0.0) - dot(size, size) * part.direction +
                    2.0 * size.y * row.x / row.y * part.down;
        part.solid_angle = size.x * size.y * row.y * (1.0 - size.y * size.y / 24.0);
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
    float second = (n - 1.0) * dot(slope, slope) / cosine + dot(part.bend, axis);
    return chord_power(half_square_distance(part.direction, axis), n) *
           (1.0 + n / 24.0 * second / cosine);
}

float part_weight(Part part, Query query) {
    float weight = part.solid_angle * part_power(part, query.axis.xyz, exponent);
    if (!CLIPPED) return weight;
    weight *= part_power(part, query.normal.xyz, 1.0);
    if (is_near_horizon(part, query.axis.xyz) || is_near_horizon(part, query.normal.xyz))
        return weight;
    // the two powers change together
    return weight * (1.0 + exponent / 12.0 *
                               dot(slopes(part, query.axis.xyz), slopes(part, query.normal.xyz)) /
                               (dot(part.direction, query.axis.xyz) *
                                dot(part.direction, query.normal.xyz)));
}

#endif
