#include "progress.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <unistd.h>

#include "messages.h"

namespace lobelia::cli {

namespace {

constexpr std::chrono::milliseconds PATIENCE{500};
constexpr std::chrono::milliseconds BETWEEN_UPDATES{200};

} // namespace

struct ProgressLine::Ticker {
    std::mutex mutex;
    std::condition_variable_any stopping;
    std::string step;
    double done = 0.0;
    std::jthread thread{[this](std::stop_token stop) { tick(stop); }}; // last: uses what is above

    void tick(const std::stop_token& stop) {
        std::unique_lock lock(mutex);
        const auto never = [] { return false; };
        stopping.wait_for(lock, stop, PATIENCE, never);
        while (!stop.stop_requested()) {
            if (!step.empty()) show_status(line());
            stopping.wait_for(lock, stop, BETWEEN_UPDATES, never);
        }
    }

    std::string line() const {
        return done > 0.0 ? step + " " + std::to_string(int(done * 100.0)) + " %" : step + " ...";
    }
};

ProgressLine::ProgressLine() {
    if (::isatty(STDERR_FILENO)) ticker_ = std::make_unique<Ticker>();
}

ProgressLine::~ProgressLine() {
    if (!ticker_) return;
    ticker_.reset();
    show_status("");
}

void ProgressLine::begin(const std::string& step) {
    if (!ticker_) return;
    const std::lock_guard lock(ticker_->mutex);
    ticker_->step = step;
    ticker_->done = 0.0;
}

host::Progress ProgressLine::listener() {
    if (!ticker_) return {};
    return [this](double done) {
        const std::lock_guard lock(ticker_->mutex);
        ticker_->done = done;
        return true;
    };
}

} // namespace lobelia::cli
