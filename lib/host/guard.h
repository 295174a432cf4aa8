#pragma once

#include <new>

#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// Runs `work`, which returns an Outcome; running out of memory becomes a failure, since no
/// exception may cross the library's boundary. Its message is short enough to need no memory.
template <class Work>
auto guarded(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return Failure{"out of memory"};
    }
}

} // namespace lobelia::host
