#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "functions.h"

namespace lobelia::test {

const char* name_of(Call call);
/// What the specification lists for the call beside VK_SUCCESS.
std::span<const VkResult> codes_of(Call call);

/// One call that fails: the `call`-th one that returns a VkResult, counted from when the plan is
/// made, and where `sticky` says so every later one that lists the code, too.
struct Fault {
    std::size_t call = 0;
    VkResult code = VK_ERROR_UNKNOWN;
    bool sticky = false;
};

/// Decides which calls fail, and remembers which there were.
class FaultPlan {
public:
    /// Forgets what was called; with a fault that call will fail.
    void begin(std::optional<Fault> fault = {});

    /// Told of every call that returns a VkResult, before it is made.
    std::optional<VkResult> answer(Call call);

    const std::vector<Call>& calls() const { return calls_; } // those that could fail
    std::size_t failed() const { return failed_; }            // how many were made to

    /// Where in the program each of calls() was made, as a number of its innermost callers; empty
    /// unless asked for, since looking takes time.
    const std::vector<std::size_t>& places() const { return places_; }
    bool remember_places = false;

private:
    std::optional<Fault> fault_;
    std::vector<Call> calls_;
    std::vector<std::size_t> places_;
    std::size_t failed_ = 0;
};

} // namespace lobelia::test
