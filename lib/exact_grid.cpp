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
// one node a cell, to second order.
constexpr float CUT_EXPONENT = 8.0f;

// Radians that a cell spans at most, and into how many parts a side a horizon's cut then divides
// it; smaller cells need fewer. A cut is taken as straight and the solid angle as even across a
// part of size p, as if the horizon lay p^2 / 6 beside its place. Below CUT_EXPONENT that
// is 2.5e-7, as much as 32 bits leave of a direction.
constexpr double LARGEST_CELL_BELOW = 2 * PI / 512;
constexpr double MOST_PARTS_BELOW = 10;
constexpr double LARGEST_CELL = 0.035;
constexpr double MOST_PARTS = 7;

// A lobe is as good as 0 where it has fallen below 2^-100 of its peak.
constexpr double LAST_BIT = 100.0;

struct CellLimit {
    double size;  // radians
    double parts; // a side of a cell that large, if a horizon cuts it
};

// Order and size of the cells for texels of at most `texel` radians. A rule of m nodes leaves a
// relative error of c_m (n h^2)^m; the limits keep it below 1e-4 where the lobe is down to 1e-6
// of its peak, with c_1 = 1.2, c_2 = 0.18 and c_3 = 0.01 there. At the lobe's own horizon three
// nodes leave about h^(n + 2) / 100, below 1e-10 for LARGEST_CELL.
CellLimit choose_rule(ExactGrid& grid, double exponent, double texel) {
    grid.order = 1;
    grid.reach = exponent > 0 ? std::acos(std::exp2(-LAST_BIT / exponent)) : PI / 2;
    if (exponent < CUT_EXPONENT) return {LARGEST_CELL_BELOW, MOST_PARTS_BELOW};
    const double sharpness = exponent * texel * texel;
    grid.order = sharpness <= 1e-4 ? 1 : sharpness <= 0.024 ? 2 : 3;
    return {std::min(0.46 / std::sqrt(exponent), LARGEST_CELL), MOST_PARTS};
}

// Cuts texels of `across` times `down` radians into cells; `grid` counts texels before and cells
// after.
void cut_texels(ExactGrid& grid, const CellLimit& limit, double across, double down) {
    const auto count = [&](double side) {
        return std::uint32_t(std::ceil(side / limit.size * (1 - 1e-9)));
    };
    grid.repeat_columns = count(across);
    grid.repeat_rows = count(down);
    grid.columns *= grid.repeat_columns;
    grid.rows *= grid.repeat_rows;
    grid.cell_width = float(across / grid.repeat_columns);
    grid.cell_height = float(down / grid.repeat_rows);
    const double largest = double(std::max(grid.cell_width, grid.cell_height));
    grid.parts = std::uint32_t(std::ceil(limit.parts * largest / limit.size * (1 - 1e-6)));
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
    ExactGrid grid{.columns = width, .rows = height, .layers = 1};
    const double across = 2 * PI / width;
    const double down = PI / height;
    cut_texels(grid, choose_rule(grid, double(exponent), std::max(across, down)), across, down);
    return grid;
}

ExactGrid cube_grid(std::uint32_t size, float exponent) {
    ExactGrid grid{.columns = size, .rows = size, .layers = 6};
    const double side = 2.0 / size;
    cut_texels(grid, choose_rule(grid, double(exponent), side), side, side);
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
