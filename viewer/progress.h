#pragma once

#include <memory>
#include <string>

#include <lobelia/host/work.h>

namespace lobelia::cli {

/// Tells a person at a terminal what goes on, for what takes longer than half a second. Says
/// nothing where stderr is not a terminal.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine();

    /// What goes on from now on, as in "reading sky.exr".
    void begin(const std::string& step);

    /// To be told by the work how far the step is. Must not outlive this.
    host::Progress listener();

private:
    struct Ticker;
    std::unique_ptr<Ticker> ticker_; // null: nobody looks
};

} // namespace lobelia::cli
