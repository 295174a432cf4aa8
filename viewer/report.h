#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <lobelia/host/gpu.h>
#include <lobelia/host/plan.h>
#include <lobelia/host/read.h>
#include <lobelia/host/work.h>

namespace lobelia::cli {

/// What was done, for --json. Its clock starts when it is made.
struct Report {
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    host::GpuDescription gpu;
    std::string method;
    std::optional<Quality> quality;           // of the prefilter, if there was one
    std::optional<host::Sanitised> sanitised; // of the environment's file, if there was one
    host::WorkReport work;

    /// Adds what was done after what is there.
    void append(const host::WorkReport& more);
};

/// One JSON object and a newline; what does not apply is null. `reasons` are told where there are
/// some.
std::string as_json(const Report& report, const std::vector<host::PlanReason>& reasons = {});

} // namespace lobelia::cli
