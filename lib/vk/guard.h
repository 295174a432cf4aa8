#pragma once

#include <new>

#include <lobelia/result.h>

namespace lobelia::vk {

/// Inside the library a failure is a thrown Error, which guarded() turns into a Result: no
/// exception crosses the boundary.
inline void check(VkResult code, const char* step) {
    if (code != VK_SUCCESS) throw Error{code, step};
}

/// Refuses what breaks a documented rule, where there is one to name.
inline void refuse(const char* broken_rule) {
    if (broken_rule) throw Error{VK_ERROR_VALIDATION_FAILED_EXT, broken_rule};
}

/// Runs `work`, which returns a Value or throws an Error. Running out of memory is an error, too.
template <class Value, class Work>
Result<Value> guarded(Work work) noexcept {
    try {
        return work();
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return Error{VK_ERROR_OUT_OF_HOST_MEMORY, "allocate host memory"};
    }
}

} // namespace lobelia::vk
