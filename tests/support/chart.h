#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "support/direction.h"

namespace lobelia::oracle {

// A chart gives the sphere, or a part of it, two coordinates u and v in which texels are boxes. In
// both charts a point is the direction (column.x * row.radius, row.y, column.z * row.radius), after
// division by its length: a column depends on u alone and a row on v alone.

struct Box {
    double u0, u1, v0, v1;
    double width() const { return u1 - u0; }
    double height() const { return v1 - v0; }
    double u() const { return 0.5 * (u0 + u1); }
    double v() const { return 0.5 * (v0 + v1); }
};
struct Column {
    double x, z;
};
struct Row {
    double radius, y;
};

/// Up to two coordinates where a great circle crosses a line of the chart.
struct Crossings {
    std::array<double, 2> at{};
    int count = 0;
};

/// u is longitude and v latitude, in radians.
struct Panorama {
    static Column column(double u) { return {std::sin(u), std::cos(u)}; }
    static Row row(double v) { return {std::cos(v), std::sin(v)}; }
    static double scale(Column, Row) { return 1; } // 1 / length of the undivided vector
    static double measure(Row row, double) { return row.radius; } // solid angle per du dv
    static double solid_angle(const Box& b) {
        return b.width() * (std::sin(b.v1) - std::sin(b.v0));
    }

    /// Of the great circle w . axis = 0, where it crosses the row, near `middle`.
    static Crossings along_row(Direction axis, Row row, double middle) {
        const double across = row.radius * std::hypot(axis.x, axis.z);
        const double height = axis.y * row.y;
        if (std::abs(height) > across || across == 0) return {};
        const double centre = std::atan2(axis.x, axis.z);
        const double reach = std::acos(-height / across);
        const auto near = [&](double u) {
            return u - 2 * PI * std::round((u - middle) / (2 * PI));
        };
        return {{near(centre - reach), near(centre + reach)}, 2};
    }
    /// The same for a column.
    static Crossings along_column(Direction axis, Column column) {
        if (axis.y == 0) return {};
        return {{std::atan(-(axis.x * column.x + axis.z * column.z) / axis.y), 0}, 1};
    }
    /// Where the great circle runs along a row: its highest and lowest latitude.
    static Crossings tangent_rows(Direction axis) {
        const double top = std::atan2(std::hypot(axis.x, axis.z), std::abs(axis.y));
        return {{-top, top}, 2};
    }
    /// Coordinates of w, u near `middle`.
    static bool locate(Direction w, double middle, double& u, double& v) {
        u = std::atan2(w.x, w.z);
        u -= 2 * PI * std::round((u - middle) / (2 * PI));
        v = std::asin(std::clamp(w.y, -1.0, 1.0));
        return true;
    }
    /// Change of w . axis (not divided by the length) per u and per v.
    static double slope_u(Direction axis, Column c, Row r) {
        return r.radius * (axis.x * c.z - axis.z * c.x);
    }
    static double slope_v(Direction axis, Column c, Row r) {
        return axis.y * r.radius - r.y * (axis.x * c.x + axis.z * c.z);
    }
};

/// u and v run from -1 to 1 over a cube face; axes are given in the frame (u, v, outwards).
struct CubeFace {
    static Column column(double u) { return {u, 1}; }
    static Row row(double v) { return {1, v}; }
    static double scale(Column c, Row r) { return 1 / std::sqrt(c.x * c.x + r.y * r.y + 1); }
    static double measure(Row, double scale) { return scale * scale * scale; }
    static double solid_angle(const Box& b) {
        const auto corner = [](double u, double v) {
            return std::atan2(u * v, std::sqrt(u * u + v * v + 1));
        };
        return corner(b.u1, b.v1) - corner(b.u0, b.v1) - corner(b.u1, b.v0) + corner(b.u0, b.v0);
    }
    static Crossings along_row(Direction axis, Row row, double) {
        if (axis.x == 0) return {};
        return {{-(axis.y * row.y + axis.z) / axis.x, 0}, 1};
    }
    static Crossings along_column(Direction axis, Column column) {
        if (axis.y == 0) return {};
        return {{-(axis.x * column.x + axis.z) / axis.y, 0}, 1};
    }
    static Crossings tangent_rows(Direction) { return {}; }
    static bool locate(Direction w, double, double& u, double& v) {
        u = w.x / w.z;
        v = w.y / w.z;
        return w.z > 0;
    }
    static double slope_u(Direction axis, Column, Row) { return axis.x; }
    static double slope_v(Direction axis, Column, Row) { return axis.y; }
};

template <class Chart>
Direction direction_at(Column column, Row row) {
    const double scale = Chart::scale(column, row);
    return {column.x * row.radius * scale, row.y * scale, column.z * row.radius * scale};
}

/// Largest angle between a box's middle and a point of it, in radians: at a corner, unless a
/// panorama's box goes more than half around.
template <class Chart>
double angular_radius(const Box& box) {
    if (box.width() > PI + 1e-9) return PI;
    const auto at = [](double u, double v) {
        return direction_at<Chart>(Chart::column(u), Chart::row(v));
    };
    const Direction middle = at(box.u(), box.v());
    return std::max({angle(middle, at(box.u0, box.v0)), angle(middle, at(box.u1, box.v0)),
                     angle(middle, at(box.u0, box.v1)), angle(middle, at(box.u1, box.v1))});
}

} // namespace lobelia::oracle
