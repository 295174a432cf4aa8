#pragma once

#include <lobelia/host/work.h>

namespace lobelia::host {

/// The maps that the sphere pass fetches from. Null where the material has no use for them.
struct SphereMaps {
    std::optional<GpuImage> diffuse;  // P_1
    std::optional<GpuImage> specular; // P_n
};
Outcome<SphereMaps> make_sphere_maps(Gpu& gpu, const GpuEnvironment& environment,
                                     const Material& material, const Progress& progress,
                                     WorkReport& report);

} // namespace lobelia::host
