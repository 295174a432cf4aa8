#pragma once

#include <initializer_list>
#include <iterator>
#include <vector>

namespace lobelia::test {

// Sanitizers look at what code does, not at the numbers it does it with.
#ifdef LOBELIA_SANITIZED
inline constexpr int ONE_IN = 4;
#else
inline constexpr int ONE_IN = 1;
#endif

/// Of inputs that differ in nothing but numbers all, or under sanitizers every fourth.
template <class Range>
auto some_of(const Range& all) {
    std::vector<typename std::iterator_traits<decltype(std::begin(all))>::value_type> some;
    int i = 0;
    for (const auto& input : all)
        if (i++ % ONE_IN == 0) some.push_back(input);
    return some;
}

template <class T>
std::vector<T> some_of(std::initializer_list<T> all) {
    return some_of<std::initializer_list<T>>(all);
}

} // namespace lobelia::test
