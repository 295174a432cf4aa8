#pragma once

#include <functional>
#include <set>
#include <string>

#include "barrier_audit.h"
#include "census.h"
#include "fault_plan.h"
#include "pipeline_store.h"

namespace lobelia::test {

/// What a physical device says of itself, changed before the caller sees it. This stands in for
/// devices that nobody here owns.
struct Spoof {
    std::function<void(VkPhysicalDeviceProperties&)> properties;
    std::function<void(VkQueueFamilyProperties&)> queue_family;
    std::function<void(VkFormat, VkFormatProperties&)> format;
    std::function<void(VkPhysicalDeviceMemoryProperties&)> memory;
    std::set<std::string> hidden; // functions that are not there
};

/// Stands between the library and the Vulkan loader: every call of the library passes through, may
/// be made to fail, and is recorded. One for the process, since Vulkan's functions carry no
/// pointer of ours; not thread safe.
class VulkanShim {
public:
    static VulkanShim& get();

    /// To be given to the library (GpuOptions::get_instance_proc_addr). It hands out functions that
    /// go through the shim, vkGetDeviceProcAddr among them.
    static PFN_vkGetInstanceProcAddr entry();

    /// Whether this thread is in a call of Vulkan.
    static inline thread_local bool inside = false;

    FaultPlan faults;
    Census census;
    PipelineStore pipelines;
    BarrierAudit audit;
    Spoof spoof;
    bool dry = false;            // dispatches and draws are not made
    bool running = false;        // submitted work that nobody has waited for
    std::size_t died_in_use = 0; // objects, while there was such
    /// Functions that the library asked for and the shim does not know: it would miss their calls.
    std::set<std::string> unknown;
};

} // namespace lobelia::test
