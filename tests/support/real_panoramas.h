#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <lobelia/host/read.h>

#include "support/gpu_sources.h"

namespace lobelia::test {

/// Photographed environments of 1024 x 512 texels: what Debian's package blender-data brings, in
/// the folder that CMake's LOBELIA_PANORAMAS names.
inline const std::vector<std::string> REAL_PANORAMAS{"city",  "courtyard", "forest",  "interior",
                                                     "night", "studio",    "sunrise", "sunset"};

inline bool has_real_panoramas() {
    return std::filesystem::exists(std::string(LOBELIA_PANORAMAS) + "/city.exr");
}

inline host::Image real_panorama(const std::string& name) {
    return value_of(host::read_environment(LOBELIA_PANORAMAS "/" + name + ".exr")).image;
}

} // namespace lobelia::test
