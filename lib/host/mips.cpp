#include "host/mips.h"

#include <algorithm>
#include <bit>

#include "host/averages.h"
#include "host/maps.h"
#include "host/sizes.h"

namespace lobelia::host {

namespace {

std::uint32_t level_count(std::uint32_t face, std::uint32_t last_face) {
    return std::uint32_t(std::bit_width(std::max(face / last_face, 1u)));
}

} // namespace

VkFormat mips_format(const Gpu& gpu) {
    const auto properties_of = reinterpret_cast<PFN_vkGetPhysicalDeviceFormatProperties>(
        gpu.get_instance_proc_addr()(gpu.instance(), "vkGetPhysicalDeviceFormatProperties"));
    VkFormatProperties found{};
    properties_of(gpu.physical_device(), VK_FORMAT_R32G32B32A32_SFLOAT, &found);
    return found.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT
               ? VK_FORMAT_R32G32B32A32_SFLOAT
               : VK_FORMAT_R16G16B16A16_SFLOAT;
}

WorkReport mips_report(const Gpu& gpu, std::uint32_t face, std::uint32_t last_face) {
    const VkFormat format = mips_format(gpu);
    const std::uint32_t levels = level_count(face, last_face);
    std::uint64_t texels = 0;
    for (std::uint32_t level = 0; level < levels; ++level) texels += cube_texels(face >> level);
    const std::uint64_t bytes = texels * (format == VK_FORMAT_R32G32B32A32_SFLOAT ? 16 : 8);
    const std::uint64_t source = TEXEL_BYTES * cube_texels(face);
    return {.passes = {{.name = "mips",
                        .invocations = texels,
                        .bytes_read = source + bytes,
                        .bytes_written = bytes}},
            .images = {{"mips", face, face, FACES, levels, format_name(format), bytes, "scratch"}}};
}

Outcome<MipsToMake> bind_mips(Gpu& gpu, const Mips& mips, const GpuImage& source,
                              std::uint32_t last_face, MipWeights weights) {
    const std::uint32_t size = source.description().width;
    auto image = gpu.create_image({.format = mips_format(gpu),
                                   .width = size,
                                   .height = size,
                                   .layers = 6,
                                   .levels = level_count(size, last_face),
                                   .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT,
                                   .cube = true});
    if (!image) return image.error();
    auto job = mips.bind(lend_cube(source), lend_cube(*image), weights);
    if (!job) return core_failure(job.error());
    return MipsToMake{std::move(*image), std::move(*job)};
}

Outcome<EnvironmentMips> make_mips(Gpu& gpu, const GpuEnvironment& environment,
                                   std::uint32_t last_face, MipWeights weights) {
    const GpuImage& source = environment.source();
    const auto mips = Mips::create(gpu.device());
    if (!mips) return core_failure(mips.error());
    auto bound = bind_mips(gpu, *mips, source, last_face, weights);
    if (!bound) return bound.error();
    EnvironmentMips made{std::move(bound->image),
                         mips_report(gpu, source.description().width, last_face)};
    const auto done = run_pass(gpu, made.report.passes.front(),
                               [&](VkCommandBuffer commands) { bound->job.record(commands); });
    if (!done) return done.error();
    return made;
}

} // namespace lobelia::host
