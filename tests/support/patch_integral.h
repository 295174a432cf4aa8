#pragma once

#include <span>

#include "support/chart.h"
#include "support/weight.h"

namespace lobelia::oracle {

/// A column with the axis and the normal applied to it, so that a point costs few operations.
struct ProjectedColumn {
    Column column;
    double axis;
    double normal;
};

/// Integrals of a weight over boxes of a chart, each to 1e-9 of itself, and to 1e-7 where a horizon
/// cuts the box. Weights too small to matter are left out: together they are below
/// 1e-16 of the weight over the whole sphere. `extra_points` refines each rule, for tests.
template <class Chart>
class PatchIntegral {
public:
    /// The directions of `weight` are in the chart's frame.
    explicit PatchIntegral(const Weight& weight, int extra_points = 0);

    double over(const Box& box) const;

    /// Points a side that a plain rule needs on a box of this `angular_radius`, `half_extent` (the
    /// larger, in chart units) and cosines at the middle; 0: none will do, call `over`.
    int plain_order(double axis_cosine, double normal_cosine, double angular_radius,
                    double half_extent) const;
    /// Cosine to the axis below which a box of this radius holds nothing that matters.
    double least_cosine(double angular_radius) const;

    ProjectedColumn project(Column column) const;
    /// The plain rule; `columns` and `rows` are those of the rule's points in the box.
    double plain(const Box& box, std::span<const ProjectedColumn> columns,
                 std::span<const Row> rows) const;

private:
    int smooth_order(double axis_cosine, double angular_radius, double half_extent) const;
    bool near_axis_horizon(double axis_cosine, double angular_radius) const;
    bool near_normal_horizon(double normal_cosine, double angular_radius) const;
    double split(const Box& box) const;

    Weight weight_;
    int extra_points_;
    double reach_; // angle from the axis beyond which nothing matters
};

extern template class PatchIntegral<Panorama>;
extern template class PatchIntegral<CubeFace>;

} // namespace lobelia::oracle
