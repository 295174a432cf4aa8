#pragma once

#include <functional>
#include <span>

namespace lobelia::test {

/// Something that the core records, on FakeDevice.
struct CoreJob {
    const char* name;
    std::function<std::function<void()>()> make; // creates and binds; what it gives records
    bool has_objects = true;                     // of Vulkan's
};

/// All there is.
std::span<const CoreJob> core_jobs();

} // namespace lobelia::test
