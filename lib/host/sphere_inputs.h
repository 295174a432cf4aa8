#pragma once

#include "host/reference.h"
#include "host/scene_plan.h"

namespace lobelia::host {

/// Everything that the sphere pass reads, with what owns it. An edit of the material needs no other
/// inputs as long as the same lobes are black and, for methods whose maps are made for an exponent,
/// the exponent stays.
struct SphereInputs {
    ScenePlan plan;
    MapPasses passes;
    SceneMaps maps;
    ReferenceBuffers references{};
    SphereShading shading{}; // the plan's, without suns where none were found
    SphereSources sources{};
    std::uint64_t bytes = 0; // of what the pass reads
    WorkReport report{};
};

/// Makes what `settings.method` reads, pass by pass.
Outcome<SphereInputs> make_sphere_inputs(Gpu& gpu, const GpuEnvironment& environment,
                                         const RenderSettings& settings, const Progress& progress);

} // namespace lobelia::host
