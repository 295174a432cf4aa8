#pragma once

#include <csignal>
#include <ctime>

namespace lobelia::host {

/// Keeps a write beyond the file size limit or into a pipe that nobody reads from ending the
/// process: for this thread and while this object lives the two signals wait, and those that arose
/// here are then dropped. The write itself fails with an error.
class QuietSignals {
public:
    QuietSignals() {
        ::sigemptyset(&quiet_);
        ::sigaddset(&quiet_, SIGXFSZ);
        ::sigaddset(&quiet_, SIGPIPE);
        sigset_t pending;
        ::sigpending(&pending);
        // One that was waiting before is the caller's.
        for (const int signal : {SIGXFSZ, SIGPIPE})
            if (::sigismember(&pending, signal)) ::sigdelset(&quiet_, signal);
        ::pthread_sigmask(SIG_BLOCK, &quiet_, &before_);
    }
    ~QuietSignals() {
        const timespec no_wait{};
        while (::sigtimedwait(&quiet_, nullptr, &no_wait) > 0) {
        }
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    QuietSignals(const QuietSignals&) = delete;
    QuietSignals& operator=(const QuietSignals&) = delete;

private:
    sigset_t quiet_;
    sigset_t before_;
};

} // namespace lobelia::host
