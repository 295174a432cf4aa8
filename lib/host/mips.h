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

/// The format of mips on this device.
VkFormat mips_format(const Gpu& gpu);

/// What a report says of mips of a cube map with faces of `face` texels, a size that prefilters
/// read.
WorkReport mips_report(const Gpu& gpu, std::uint32_t face, std::uint32_t last_face);

/// Mips that are ready to be made.
struct MipsToMake {
    GpuImage image;
    MipsJob job;
};
/// Of a cube map in a size that prefilters read. Levels down to faces of `last_face` texels, a
/// power of two; of a cube map that is no larger, level 0 alone.
Outcome<MipsToMake> bind_mips(Gpu& gpu, const Mips& mips, const GpuImage& source,
                              std::uint32_t last_face, MipWeights weights);

Outcome<EnvironmentMips> make_mips(Gpu& gpu, const GpuEnvironment& environment,
                                   std::uint32_t last_face, MipWeights weights);

} // namespace lobelia::host
