#pragma once

#include <lobelia/host/plan.h>

namespace lobelia::host {

/// What brings an environment to the device.
struct EnvironmentPlan {
    std::uint32_t face = 0; // of its cube map
    WorkReport report;
    std::vector<double> work; // what each pass's time is in proportion to
};
EnvironmentPlan plan_environment(const EnvironmentShape& shape, std::uint32_t face,
                                 Quality quality);

/// Bytes of what Exact integrates: the panorama, or the cube map where there is none.
std::uint64_t source_bytes(const EnvironmentShape& shape);

} // namespace lobelia::host
