#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <lobelia/host/read.h>

namespace lobelia::cli {

/// Reads environment maps, each on a thread of its own. Waits for them at its end.
class Loader {
public:
    /// Reads this file; what was being read is not wanted any more.
    void begin(const std::string& path);
    bool is_busy() const { return job_ != nullptr; }
    const std::string& path() const { return path_; }
    double seconds() const;
    /// What was read, once; nothing while it is read, or when nothing was asked for.
    std::optional<host::Outcome<host::Environment>> take();

private:
    struct Job;
    std::shared_ptr<Job> job_;          // null: idle
    std::vector<std::jthread> threads_; // of this job and earlier ones
    std::string path_;
    std::chrono::steady_clock::time_point began_;
};

} // namespace lobelia::cli
