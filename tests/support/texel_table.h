#pragma once

#include <array>
#include <vector>

#include "support/chart.h"

namespace lobelia::oracle {

inline constexpr int MAX_TABLE_POINTS = 14;

/// What depends on an image's size alone. The texels of a layer are the boxes of a grid in the
/// coordinates of a chart, so points within them come from a list a column and a list a row.
struct TexelTable {
    /// Columns and rows of the m points a side of the Gauss rule in each texel: [m][x * m + j].
    std::array<std::vector<Column>, MAX_TABLE_POINTS + 1> columns;
    std::array<std::vector<Row>, MAX_TABLE_POINTS + 1> rows;
    /// Edges of the texels. On a panorama longitude falls as x grows, and latitude as y grows.
    std::vector<double> u;
    std::vector<double> v;
    /// Angular radius in radians, of each texel of a cube's face or of each row of a panorama.
    std::vector<double> radius;

    Box box(int x, int y) const {
        const auto i = std::size_t(x);
        const auto j = std::size_t(y);
        return {std::min(u[i], u[i + 1]), std::max(u[i], u[i + 1]), std::min(v[j], v[j + 1]),
                std::max(v[j], v[j + 1])};
    }
};

} // namespace lobelia::oracle
