#pragma once

#include <csignal>

namespace lobelia::cli {

/// While this object lives, what would end the program (Ctrl-C, a hang-up, a request to terminate)
/// waits until it goes: a file is then written whole or not at all. One at a time.
class DeferredInterrupts {
public:
    DeferredInterrupts();
    ~DeferredInterrupts();
    DeferredInterrupts(const DeferredInterrupts&) = delete;
    DeferredInterrupts& operator=(const DeferredInterrupts&) = delete;

private:
    static constexpr int SIGNALS[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction before_[3];
};

} // namespace lobelia::cli
