#pragma once

#include <lobelia/host/work.h>

namespace lobelia::host {

/// The averages that SphereMethod::reference shows, one for each pixel; of a lobe whose reflectance
/// is black there are none.
struct ReferenceBuffers {
    std::optional<GpuBuffer> diffuse, specular;
    WorkReport report;
};

/// Integrates the environment with Exact for every pixel that the sphere may cover.
Outcome<ReferenceBuffers> make_references(Gpu& gpu, const GpuEnvironment& environment,
                                          const SphereView& view, const Progress& progress);

} // namespace lobelia::host
