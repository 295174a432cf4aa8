#pragma once

#include "support/chart.h"
#include "support/weight.h"

namespace lobelia::oracle {

/// How to integrate a box that a horizon cuts or grazes.
struct KinkRule {
    int points;     // of the Gauss rule on each piece of a line
    bool axis_kink; // the horizon of the axis is near, else that of the normal alone
    bool graded;    // at the corners of what is covered no polynomial follows
};

/// The integral of `weight` over a box of a chart of at most 0.26 a side: of line integrals, the
/// lines across the horizon, cut wherever a horizon meets an edge or the other horizon.
template <class Chart>
double integrate_across_horizon(const Weight& weight, const Box& box, const KinkRule& rule);

} // namespace lobelia::oracle
