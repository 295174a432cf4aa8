#pragma once

#include <optional>

#include <lobelia/host/outcome.h>

#include "host/gpu_functions.h"

namespace lobelia::host {

/// Measures commands by the device's own clock. Without one, by default or because the queue has
/// none, it records nothing and has no result.
class Timestamps {
public:
    Timestamps() = default;
    /// For a queue whose timestamps have `valid_bits` bits, each tick `period` nanoseconds.
    static Outcome<Timestamps> create(const HostContext& context, std::uint32_t valid_bits,
                                      float period);

    /// Around the commands to measure, once each in a command buffer.
    void record_begin(VkCommandBuffer commands) const;
    void record_end(VkCommandBuffer commands) const;

    /// Milliseconds between the two, once the commands have run.
    Outcome<std::optional<double>> milliseconds() const;

private:
    const HostContext* context_ = nullptr;
    HostObject<VkQueryPool, &DeviceFunctions::vkDestroyQueryPool> pool_;
    std::uint64_t mask_ = 0; // of the bits that count
    double period_ = 0.0;
};

} // namespace lobelia::host
