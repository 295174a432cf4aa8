#include "fault_plan.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <execinfo.h>

namespace lobelia::test {

namespace {

struct Listed {
    const char* name;
    std::vector<VkResult> codes;
};

const Listed& listed(Call call) {
    static const std::vector<Listed> all{
#define X(name, ...) Listed{#name, {__VA_ARGS__}},
        LOBELIA_SHIM_FUNCTIONS(X)
#undef X
    };
    return all[std::size_t(call)];
}

// The innermost callers, up to what one workload does and another does not.
std::size_t place() {
    std::array<void*, 7> frames{};
    const int depth = ::backtrace(frames.data(), int(frames.size()));
    return std::hash<std::string_view>()(std::string_view(
        reinterpret_cast<const char*>(frames.data()), std::size_t(depth) * sizeof frames[0]));
}

bool lists(Call call, VkResult code) {
    const auto codes = codes_of(call);
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

} // namespace

const char* name_of(Call call) {
    return listed(call).name;
}

std::span<const VkResult> codes_of(Call call) {
    return listed(call).codes;
}

void FaultPlan::begin(std::optional<Fault> fault) {
    fault_ = fault;
    calls_.clear();
    places_.clear();
    failed_ = 0;
}

std::optional<VkResult> FaultPlan::answer(Call call) {
    const std::size_t index = calls_.size();
    calls_.push_back(call);
    if (remember_places) places_.push_back(place());
    if (!fault_ || index < fault_->call) return {};
    if (index > fault_->call && !(fault_->sticky && lists(call, fault_->code))) return {};
    ++failed_;
    return fault_->code;
}

} // namespace lobelia::test
