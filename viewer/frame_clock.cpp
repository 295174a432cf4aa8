#include "frame_clock.h"

#include <algorithm>
#include <ctime>

namespace lobelia::cli {

double FrameClock::process_ms() {
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

void FrameClock::tick() {
    const double seconds = since_frame();
    last_ = Clock::now();
    const double now = process_ms();
    cpu_ms_ = now - process_ms_;
    process_ms_ = now;
    const double weight = seconds > 0.5 ? 1.0 : 0.1; // it stood still
    rate_ += weight * (1.0 / std::max(seconds, 1e-6) - rate_);
}

} // namespace lobelia::cli
