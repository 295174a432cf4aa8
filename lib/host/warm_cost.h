#pragma once

#include <lobelia/host/measure.h>

namespace lobelia::host {

/// Runs something once and adds its times to the report.
using TimedWork = std::function<Outcome<Done>(PassReport&)>;

/// Runs `work` until it is warm and then several times. Of the cost only the times are set.
Outcome<Cost> warm_cost(const Gpu& gpu, const TimedWork& work);

/// The cost by a single run, scaled up. Of the cost only the times are set.
Cost once(const PassReport& ran, double scale);

void scale_times(Cost& cost, double scale);

/// Adds the times of `ran` to those of `report`.
void add_times(PassReport& report, const PassReport& ran);

/// Runs `count` of equal parts.
using PartialWork = std::function<Outcome<Done>(std::size_t count, PassReport&)>;

/// The same for work that consists of `parts` equal parts: runs as many as take long enough to be
/// timed, and scales up.
Outcome<Cost> warm_cost(const Gpu& gpu, std::size_t parts, const PartialWork& work);

} // namespace lobelia::host
