#pragma once

#include <new>

#include <lobelia/result.h>

namespace lobelia::vk {

/// Runs `work`, which returns a Result; running out of memory becomes an error, since no exception
/// may cross the library's boundary.
template <class Work>
auto guarded(Work work) noexcept -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Error{VK_ERROR_OUT_OF_HOST_MEMORY, "allocate host memory"};
    }
}

} // namespace lobelia::vk
