#pragma once

#include <chrono>

namespace lobelia::cli {

/// What frames take, one after another.
class FrameClock {
public:
    /// A frame is done.
    void tick();

    double seconds() const { return seconds_since(began_); } // since the start
    double since_frame() const { return seconds_since(last_); }
    double frames_per_second() const { return rate_; } // lately
    double cpu_ms() const { return cpu_ms_; }          // process CPU time of the last frame

private:
    using Clock = std::chrono::steady_clock;
    static double seconds_since(Clock::time_point time) {
        return std::chrono::duration<double>(Clock::now() - time).count();
    }
    static double process_ms();

    Clock::time_point began_ = Clock::now(), last_ = began_;
    double process_ms_ = process_ms();
    double rate_ = 0.0, cpu_ms_ = 0.0;
};

} // namespace lobelia::cli
