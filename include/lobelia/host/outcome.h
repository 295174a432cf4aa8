#pragma once

#include <string>

#include <lobelia/result.h>

namespace lobelia::host {

/// Why a host convenience failed, as one line for a person: what, where, and what to do.
struct Failure {
    std::string message;
};

/// A value, or the reason why there is none.
template <class T>
using Outcome = Result<T, Failure>;

} // namespace lobelia::host
