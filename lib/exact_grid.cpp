#include "exact_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace lobelia {

namespace {

constexpr double PI = std::numbers::pi;

struct Rule { // Gauss-Legendre on [-1, 1], weights that sum to 1
    double node, weight;
};
constexpr Rule RULE_1[] = {{0.0, 1.0}};
constexpr Rule RULE_2[] = {{-0.57735026918962576, 0.5}, {0.57735026918962576, 0.5}};
constexpr Rule RULE_3[] = {
    {-0.77459666924148338, 5.0 / 18}, {0.0, 8.0 / 18}, {0.77459666924148338, 5.0 / 18}};

std::span<const Rule> rule(std::uint32_t order) {
    if (order == 1) return RULE_1;
    if (order == 2) return RULE_2;
    return RULE_3;
}

// Below this exponent the horizon's cut through a texel matters more than the lobe's curvature:
// one node a cell, whose cut is integrated in closed form.
constexpr float CUT_EXPONENT = 4.0f;

// A lobe is as good as 0 where it has fallen below 2^-100 of its peak.
constexpr double LAST_BIT = 100.0;

// Order and number of cells for texels of at most `texel` radians. A rule of m nodes leaves a
// relative error of c_m (n h^2)^m; the limits keep it below 1e-4 where the lobe is down to 1e-6
// of its peak, with c_1 = 1.2, c_2 = 0.18 and c_3 = 0.01 there.
void choose_resolution(ExactGrid& grid, float exponent, double texel) {
    const double sharpness = double(exponent) * texel * texel;
    double largest_cell = texel;
    if (exponent < CUT_EXPONENT) {
        grid.order = 1;
        largest_cell = 2 * PI / 512; // the cut is taken as straight
    } else if (sharpness <= 1e-4) {
        grid.order = 1;
    } else if (sharpness <= 0.024) {
        grid.order = 2;
    } else {
        grid.order = 3;
        largest_cell = 0.46 / std::sqrt(double(exponent));
    }
    grid.repeat = std::uint32_t(std::ceil(texel / largest_cell * (1 - 1e-9)));
    grid.reach = exponent > 0 ? std::acos(std::exp2(-LAST_BIT / double(exponent))) : PI / 2;
}

// Longitudes and latitudes; a row's shares add up to its exact solid angle per radian of longitude.
void add_panorama_nodes(const ExactGrid& grid, std::vector<ExactNode>& nodes) {
    const std::span<const Rule> within = rule(grid.order);
    const double width = 2 * PI / grid.columns;
    const double height = PI / grid.rows;
    for (std::uint32_t column = 0; column < grid.columns; ++column)
        for (const Rule& at : within) {
            const double longitude = PI - (column + 0.5 + 0.5 * at.node) * width;
            nodes.push_back({float(std::sin(longitude)), float(std::cos(longitude)),
                             float(at.weight * width), 0});
        }
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        const double top = PI / 2 - row * height;
        const auto latitude = [&](const Rule& at) { return top - (0.5 + 0.5 * at.node) * height; };
        double sum = 0;
        for (const Rule& at : within) sum += at.weight * std::cos(latitude(at));
        const double per_weight = (std::sin(top) - std::sin(top - height)) / sum;
        for (const Rule& at : within)
            nodes.push_back({float(std::sin(latitude(at))), float(std::cos(latitude(at))),
                             float(per_weight * at.weight * std::cos(latitude(at))), 0});
    }
}

// Face coordinates, the same for columns and rows.
void add_cube_nodes(const ExactGrid& grid, std::vector<ExactNode>& nodes) {
    const double width = 2.0 / grid.columns;
    for (std::uint32_t i = 0; i < grid.columns + grid.rows; ++i)
        for (const Rule& at : rule(grid.order))
            nodes.push_back({float((i % grid.columns + 0.5 + 0.5 * at.node) * width - 1), 0,
                             float(at.weight * width), 0});
}

} // namespace

ExactGrid panorama_grid(std::uint32_t width, std::uint32_t height, float exponent) {
    ExactGrid grid{.layers = 1};
    choose_resolution(grid, exponent, std::max(2 * PI / width, PI / height));
    grid.columns = width * grid.repeat;
    grid.rows = height * grid.repeat;
    grid.cell_width = float(2 * PI / grid.columns);
    grid.cell_height = float(PI / grid.rows);
    return grid;
}

ExactGrid cube_grid(std::uint32_t size, float exponent) {
    ExactGrid grid{.layers = 6};
    choose_resolution(grid, exponent, 2.0 / size);
    grid.columns = grid.rows = size * grid.repeat;
    grid.cell_width = grid.cell_height = 2.0f / float(grid.columns);
    return grid;
}

std::size_t node_count(const ExactGrid& grid) {
    return (std::size_t(grid.columns) + grid.rows) * grid.order;
}

std::vector<ExactNode> make_nodes(const ExactGrid& grid) {
    std::vector<ExactNode> nodes;
    nodes.reserve(node_count(grid));
    if (grid.layers == 1)
        add_panorama_nodes(grid, nodes);
    else
        add_cube_nodes(grid, nodes);
    return nodes;
}

} // namespace lobelia
