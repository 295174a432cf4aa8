#pragma once

#include <cstdint>
#include <vector>

#include <lobelia/host/work.h>

namespace lobelia::host {

struct MapSize {
    std::uint32_t width, height;
};

/// The size of each map that `settings` ask for.
std::vector<MapSize> map_sizes(const PrefilterSettings& settings);

/// Why there can be no maps as they are asked for.
Outcome<Done> check_prefilter(const PrefilterSettings& settings);

} // namespace lobelia::host
