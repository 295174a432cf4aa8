#include "interrupts.h"

#include <iterator>

namespace lobelia::cli {

namespace {

volatile std::sig_atomic_t arrived = 0;

extern "C" void remember(int signal) {
    arrived = signal;
}

} // namespace

DeferredInterrupts::DeferredInterrupts() {
    arrived = 0;
    struct sigaction deferred {};
    deferred.sa_handler = remember;
    deferred.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < std::size(SIGNALS); ++i) {
        ::sigaction(SIGNALS[i], nullptr, &before_[i]);
        // What the caller had this program ignore (nohup) stays ignored.
        if (before_[i].sa_handler != SIG_IGN) ::sigaction(SIGNALS[i], &deferred, nullptr);
    }
}

DeferredInterrupts::~DeferredInterrupts() {
    for (std::size_t i = 0; i < std::size(SIGNALS); ++i)
        ::sigaction(SIGNALS[i], &before_[i], nullptr);
    if (arrived) std::raise(arrived);
}

} // namespace lobelia::cli
