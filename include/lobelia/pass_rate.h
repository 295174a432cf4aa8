#pragma once

#include <cstdint>
#include <span>

#include <lobelia/export.h>

namespace lobelia {

/// How fast a device runs passes of one name: learned from passes that were timed on it.
struct PassRate {
    const char* name = ""; // as in PrefilterPass and ScenePass
    double milliseconds_per_work = 0;
};

/// The time of a pass of this name and `work`; 0 where its rate is not there.
LOBELIA_API double predicted_milliseconds(std::span<const PassRate> rates, const char* name,
                                          double work) noexcept;

} // namespace lobelia
