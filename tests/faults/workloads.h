#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <lobelia/host/gpu.h>

namespace lobelia::test {

/// Something that programs do with the library, small: what it gives are the texels it made.
struct Workload {
    std::string name;
    std::function<host::Outcome<std::vector<float>>(host::Gpu&)> run;
};

/// Workloads that share most of their ways through the library.
struct WorkloadGroup {
    std::string name;
    std::vector<Workload> workloads;
};
inline std::ostream& operator<<(std::ostream& out, const WorkloadGroup& group) {
    return out << group.name;
}
const std::vector<WorkloadGroup>& workload_groups();

} // namespace lobelia::test
