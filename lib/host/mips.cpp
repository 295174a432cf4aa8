#include "host/mips.h"

#include <algorithm>
#include <bit>

#include "host/averages.h"
#include "host/maps.h"

namespace lobelia::host {

namespace {

VkFormat filterable_format(const Gpu& gpu) {
    const auto properties_of = reinterpret_cast<PFN_vkGetPhysicalDeviceFormatProperties>(
        gpu.get_instance_proc_addr()(gpu.instance(), "vkGetPhysicalDeviceFormatProperties"));
    VkFormatProperties found{};
    properties_of(gpu.physical_device(), VK_FORMAT_R32G32B32A32_SFLOAT, &found);
    return found.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT
               ? VK_FORMAT_R32G32B32A32_SFLOAT
               : VK_FORMAT_R16G16B16A16_SFLOAT;
}

} // namespace

Outcome<EnvironmentMips> make_mips(Gpu& gpu, const GpuEnvironment& environment,
                                   std::uint32_t last_face, MipWeights weights) {
    const auto resized = resized_cube(gpu, environment);
    if (!resized) return resized.error();
    const GpuImage& source = *resized ? **resized : environment.cube;
    const std::uint32_t size = source.description().width;
    auto image =
        gpu.create_image({.format = filterable_format(gpu),
                          .width = size,
                          .height = size,
                          .layers = 6,
                          .levels = std::uint32_t(std::bit_width(std::max(size / last_face, 1u))),
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT,
                          .cube = true});
    if (!image) return image.error();
    const auto mips = Mips::create(gpu.device());
    if (!mips) return core_failure(mips.error());
    const auto job = mips->bind(lend_cube(source), lend_cube(*image), weights);
    if (!job) return core_failure(job.error());

    const std::uint64_t bytes = image_bytes(*image);
    PassReport run{.name = "mips",
                   .invocations = image_texels(*image),
                   .bytes_read = image_bytes(source) + bytes,
                   .bytes_written = bytes};
    const auto done = run_pass(gpu, run, [&](VkCommandBuffer commands) { job->record(commands); });
    if (!done) return done.error();
    EnvironmentMips made{std::move(*image), {}};
    made.report.passes.push_back(run);
    made.report.images.push_back(image_report("mips", made.image, "scratch"));
    return made;
}

} // namespace lobelia::host
