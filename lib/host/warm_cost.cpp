#include "host/warm_cost.h"

#include <algorithm>
#include <cmath>

namespace lobelia::host {

namespace {

constexpr int RUNS = 7;
constexpr int MOST_REPEATS = 64; // of the work in a run
// A run is at least so long: what a CPU device's own threads have used arrives late in the
// process's time, and timers tick.
constexpr double LEAST_MILLISECONDS = 10.0;
constexpr std::size_t FIRST_PARTS = 16;

/// The clock by which a device is judged.
double judged(const Gpu& gpu, const PassReport& run) {
    const bool by_device = run.gpu_ms && gpu.description().type != "cpu";
    return by_device ? *run.gpu_ms : run.cpu_ms.value_or(0.0);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

Outcome<Cost> warm_cost(const Gpu& gpu, const TimedWork& work) {
    PassReport first, warm;
    if (const auto done = work(first); !done) return done.error();
    if (const auto done = work(warm); !done) return done.error();
    const double expected = std::max(judged(gpu, warm), LEAST_MILLISECONDS / MOST_REPEATS);
    const int repeats = std::max(int(std::ceil(LEAST_MILLISECONDS / expected)), 1);

    std::vector<double> cpu, device, clock;
    for (int run = 0; run < RUNS; ++run) {
        PassReport ran;
        for (int i = 0; i < repeats; ++i)
            if (const auto done = work(ran); !done) return done.error();
        cpu.push_back(ran.cpu_ms.value_or(0.0) / repeats);
        if (ran.gpu_ms) device.push_back(*ran.gpu_ms / repeats);
        clock.push_back(judged(gpu, ran) / repeats);
    }
    const auto [shortest, longest] = std::minmax_element(clock.begin(), clock.end());
    const double middle = median(clock);
    Cost cost{.cpu_ms = median(cpu),
              .spread = middle > 0.0 ? (*longest - *shortest) / middle : 0.0};
    if (!device.empty()) cost.gpu_ms = median(device);
    return cost;
}

Cost once(const PassReport& ran, double scale) {
    Cost cost{.cpu_ms = ran.cpu_ms.value_or(0.0), .gpu_ms = ran.gpu_ms};
    scale_times(cost, scale);
    return cost;
}

void scale_times(Cost& cost, double scale) {
    cost.cpu_ms *= scale;
    if (cost.gpu_ms) *cost.gpu_ms *= scale;
}

void add_times(PassReport& report, const PassReport& ran) {
    report.cpu_ms = report.cpu_ms.value_or(0.0) + ran.cpu_ms.value_or(0.0);
    if (ran.gpu_ms) report.gpu_ms = report.gpu_ms.value_or(0.0) + *ran.gpu_ms;
}

Outcome<Cost> warm_cost(const Gpu& gpu, std::size_t parts, const PartialWork& work) {
    std::size_t count = std::min(FIRST_PARTS, parts);
    PassReport first;
    if (const auto done = work(count, first); !done) return done.error();
    while (count < parts) {
        PassReport ran;
        if (const auto done = work(count, ran); !done) return done.error();
        if (judged(gpu, ran) >= LEAST_MILLISECONDS) break;
        count = std::min(2 * count, parts);
    }
    auto cost = warm_cost(gpu, [&](PassReport& report) { return work(count, report); });
    if (!cost) return cost.error();
    scale_times(*cost, double(parts) / double(count));
    return cost;
}

} // namespace lobelia::host
