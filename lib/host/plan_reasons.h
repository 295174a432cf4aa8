#pragma once

#include <lobelia/host/plan.h>

namespace lobelia::host {

/// What is known of an environment on the device.
struct KnownEnvironment {
    std::uint32_t face = 0; // of its cube map
    bool constant = false;
};

/// For each effect why it is in or out, by planning the same with it and without.
Outcome<std::vector<PlanReason>> render_reasons(const Gpu& gpu, const KnownEnvironment& environment,
                                                const RenderSettings& settings, const Rates& rates);
Outcome<std::vector<PlanReason>>
prefilter_reasons(std::uint32_t face, const PrefilterSettings& settings, const Rates& rates);

} // namespace lobelia::host
