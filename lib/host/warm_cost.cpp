#include "host/warm_cost.h"

#include <algorithm>
#include <cmath>

namespace lobelia::host {

namespace {

constexpr int TURNS = 11;
constexpr int MOST_REPEATS = 64; // of the work in a turn
// A turn is at least so long: what a CPU device's own threads have used arrives late in the
// process's time, and timers tick.
constexpr double LEAST_MILLISECONDS = 10.0;
constexpr std::size_t FIRST_PARTS = 16;

/// The clock by which a device is judged.
double judged(const Gpu& gpu, const PassReport& run) {
    const bool by_device = run.gpu_ms && gpu.description().type != "cpu";
    return by_device ? *run.gpu_ms : run.cpu_ms.value_or(0.0);
}

void scale_times(Cost& cost, double scale) {
    cost.cpu_ms *= scale;
    if (cost.gpu_ms) *cost.gpu_ms *= scale;
}

/// The times of one work, by run.
class Runs {
public:
    explicit Runs(const TimedWork& work) : work_(work) {}

    Outcome<Done> warm_up(const Gpu& gpu) {
        PassReport first, warm;
        if (const auto done = work_.run(first); !done) return done.error();
        if (const auto done = work_.run(warm); !done) return done.error();
        const double expected = std::max(judged(gpu, warm), LEAST_MILLISECONDS / MOST_REPEATS);
        repeats_ = std::max(int(std::ceil(LEAST_MILLISECONDS / expected)), 1);
        return Done{};
    }

    Outcome<Done> add(const Gpu& gpu) {
        PassReport ran;
        for (int i = 0; i < repeats_; ++i)
            if (const auto done = work_.run(ran); !done) return done.error();
        cpu_.push_back(ran.cpu_ms.value_or(0.0) / repeats_);
        if (ran.gpu_ms) device_.push_back(*ran.gpu_ms / repeats_);
        clock_.push_back(judged(gpu, ran) / repeats_);
        return Done{};
    }

    Cost cost() const {
        const auto [shortest, longest] = std::minmax_element(clock_.begin(), clock_.end());
        const double middle = median(clock_);
        Cost cost{.cpu_ms = median(cpu_),
                  .spread = middle > 0.0 ? (*longest - *shortest) / middle : 0.0};
        if (!device_.empty()) cost.gpu_ms = median(device_);
        scale_times(cost, work_.scale);
        return cost;
    }

private:
    const TimedWork& work_;
    int repeats_ = 1;
    std::vector<double> cpu_, device_, clock_;
};

} // namespace

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Outcome<std::vector<Cost>> warm_costs(const Gpu& gpu, std::span<const TimedWork> works) {
    std::vector<Runs> all(works.begin(), works.end());
    for (Runs& runs : all)
        if (const auto done = runs.warm_up(gpu); !done) return done.error();
    for (int turn = 0; turn < TURNS; ++turn)
        for (Runs& runs : all)
            if (const auto done = runs.add(gpu); !done) return done.error();
    std::vector<Cost> costs;
    for (const Runs& runs : all) costs.push_back(runs.cost());
    return costs;
}

Outcome<TimedWork> part_of(const Gpu& gpu, std::size_t parts, const PartialWork& work) {
    std::size_t count = std::min(FIRST_PARTS, parts);
    PassReport first;
    if (const auto done = work(count, first); !done) return done.error();
    while (count < parts) {
        PassReport ran;
        if (const auto done = work(count, ran); !done) return done.error();
        if (2.0 * judged(gpu, ran) > AFFORDABLE_MILLISECONDS) break;
        count = std::min(2 * count, parts);
    }
    return TimedWork{[work, count](PassReport& report) { return work(count, report); },
                     double(parts) / double(count)};
}

Outcome<std::vector<Measured>> add_warm_costs(const Gpu& gpu, std::vector<Untimed> methods) {
    std::vector<TimedWork> works;
    for (const Untimed& method : methods)
        if (method.work) works.push_back(*method.work);
    const auto costs = warm_costs(gpu, works);
    if (!costs) return costs.error();
    std::vector<Measured> measured;
    auto timed = costs->begin();
    for (Untimed& method : methods) {
        Cost& cost = method.found.cost;
        if (method.work) {
            cost.cpu_ms = timed->cpu_ms;
            cost.gpu_ms = timed->gpu_ms;
            cost.spread = timed->spread;
            ++timed;
        }
        measured.push_back(std::move(method.found));
    }
    return measured;
}

Cost once(const PassReport& ran, double scale) {
    Cost cost{.cpu_ms = ran.cpu_ms.value_or(0.0), .gpu_ms = ran.gpu_ms};
    scale_times(cost, scale);
    return cost;
}

void add_times(PassReport& report, const PassReport& ran) {
    report.cpu_ms = report.cpu_ms.value_or(0.0) + ran.cpu_ms.value_or(0.0);
    if (ran.gpu_ms) report.gpu_ms = report.gpu_ms.value_or(0.0) + *ran.gpu_ms;
}

} // namespace lobelia::host
