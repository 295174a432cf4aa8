#pragma once

#include <lobelia/prefilter.h>

namespace lobelia::test {

inline constexpr Quality QUALITIES[] = {Quality::fast, Quality::normal, Quality::high};

} // namespace lobelia::test
