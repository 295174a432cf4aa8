#pragma once

#include <span>
#include <vector>

#include <lobelia/host/measure.h>

namespace lobelia::host {

/// What a run may take, where there is a choice. Twice or four times as much would be too long, so
/// that what is chosen takes long enough to hide its overhead, and all of it where that is cheap.
constexpr double AFFORDABLE_MILLISECONDS = 50.0;

/// Work to be timed, which can be run any number of times.
struct TimedWork {
    std::function<Outcome<Done>(PassReport&)> run; // once; adds its times to the report
    double scale = 1.0;                            // what it costs is the times of a run by this
};

/// What `works` cost: each is run until it is warm, and then all in turns, several times, so that
/// what disturbs the machine meanwhile disturbs all alike. Of a cost only the times are set.
Outcome<std::vector<Cost>> warm_costs(const Gpu& gpu, std::span<const TimedWork> works);

/// Runs `count` of equal parts.
using PartialWork = std::function<Outcome<Done>(std::size_t count, PassReport&)>;

/// Of work that consists of `parts` equal parts, as many as are affordable.
Outcome<TimedWork> part_of(const Gpu& gpu, std::size_t parts, const PartialWork& work);

/// What a method found, and all that it costs but for the times, which its work will tell; without
/// work they are known already.
struct Untimed {
    Measured found;
    std::optional<TimedWork> work;
};
Outcome<std::vector<Measured>> add_warm_costs(const Gpu& gpu, std::vector<Untimed> methods);

/// The middle of them in order, of which there is one at least.
double median(std::vector<double> values);

/// The cost by a single run, scaled up. Of the cost only the times are set.
Cost once(const PassReport& ran, double scale);

/// Adds the times of `ran` to those of `report`.
void add_times(PassReport& report, const PassReport& ran);

} // namespace lobelia::host
