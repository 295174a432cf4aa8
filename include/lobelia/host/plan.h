#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <lobelia/host/work.h>

namespace lobelia::host {

/// An environment as far as it decides what is recorded.
struct EnvironmentShape {
    Layout layout = Layout::latlong;
    std::uint32_t width = 0; // of the panorama, or edge of the cube map's faces, texels
    std::uint32_t height = 0;
    bool builtin = false;  // made on the device
    bool constant = false; // one colour everywhere
};
EnvironmentShape shape_of(const Image& environment);
EnvironmentShape builtin_shape();

/// Milliseconds for each unit of work of passes by their names, as measured on a device.
using Rates = std::map<std::string, double>;
/// 0 where the name is not among them.
double predicted_milliseconds(const Rates& rates, const std::string& name, double work);

/// Why an effect is in a plan or not, and what it costs, or would.
struct PlanReason {
    std::string effect;
    bool in = false;
    std::string why;
    double milliseconds = 0; // predicted: that it takes, or would take if it were in
    std::uint64_t bytes = 0; // read and written, likewise
};

/// What work would record. The report is that of the work itself, but for its times, which are
/// predicted: `cpu_ms` on a CPU device, else `gpu_ms`; without rates there are none.
struct WorkPlan {
    WorkReport report;
    std::vector<PlanReason> reasons;
};

/// What bringing the environment to the device and render() record; nothing of it runs. `face` is
/// that of upload_environment(). Refuses what render() refuses.
Outcome<WorkPlan> plan_render(const Gpu& gpu, const EnvironmentShape& environment,
                              std::uint32_t face, const RenderSettings& settings,
                              const Rates& rates = {});

/// The same of prefilter(), on an environment of the default face.
Outcome<WorkPlan> plan_prefilter(const Gpu& gpu, const EnvironmentShape& environment,
                                 const PrefilterSettings& settings, const Rates& rates = {});

/// Times every kind of pass of these settings on a small environment of the library's own: a second
/// on two CPU cores.
Outcome<Rates> measure_rates(Gpu& gpu, const RenderSettings& settings);
Outcome<Rates> measure_rates(Gpu& gpu, const PrefilterSettings& settings);

} // namespace lobelia::host
