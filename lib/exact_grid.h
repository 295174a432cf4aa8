#pragma once

#include <cstdint>
#include <vector>

namespace lobelia {

/// The cells and nodes over which exact.comp integrates one environment for one exponent.
struct ExactGrid {
    std::uint32_t columns;        // cells
    std::uint32_t rows;           // cells of one layer
    std::uint32_t layers;         // 1, or the 6 faces of a cube
    std::uint32_t repeat_columns; // cells in the width of one texel
    std::uint32_t repeat_rows;    // cells in its height
    std::uint32_t order;          // nodes a side of one cell
    std::uint32_t parts;          // a side, of a cell that a horizon cuts
    float cell_width;             // longitude or u
    float cell_height;            // latitude or v
    double reach;                 // radians from its axis at which the lobe ends
};

struct ExactNode { // as in exact.comp
    float x, y, share, unused;
};

ExactGrid panorama_grid(std::uint32_t width, std::uint32_t height, float exponent);
ExactGrid cube_grid(std::uint32_t size, float exponent);

/// The number of nodes, and the nodes: `order` for each column, then for each row of one layer.
std::size_t node_count(const ExactGrid& grid);
std::vector<ExactNode> make_nodes(const ExactGrid& grid);

} // namespace lobelia
