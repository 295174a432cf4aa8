#pragma once

#include <lobelia/host/work.h>
#include <lobelia/mips.h>

namespace lobelia::host {

/// The environment's cube map with mips, in SHADER_READ_ONLY_OPTIMAL: in 32 bits where the device
/// filters them, else in 16.
struct EnvironmentMips {
    GpuImage image;
    WorkReport report;
};

/// Levels down to faces of `last_face` texels, a power of two; of a cube map that is no larger,
/// level 0 alone.
Outcome<EnvironmentMips> make_mips(Gpu& gpu, const GpuEnvironment& environment,
                                   std::uint32_t last_face, MipWeights weights);

} // namespace lobelia::host
