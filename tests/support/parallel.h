#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

namespace lobelia::oracle {

/// Calls f(i) for each i below `count`, on two threads, in no order; returns when all are done.
/// f must be safe to call from two threads and must not throw.
template <class Function>
void parallel_for(std::size_t count, Function f) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) f(i);
    };
    std::thread second(work);
    work();
    second.join();
}

} // namespace lobelia::oracle
