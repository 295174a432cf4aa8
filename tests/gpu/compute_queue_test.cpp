#include <gtest/gtest.h>

#include <lobelia/host/work.h>

#include "support/gpu_sources.h"

// Everything but the sphere can be recorded for a queue that has no graphics. There the driver's
// queue has them, so validation would not tell: the stages that barriers name do.
namespace lobelia::test {
namespace {

constexpr VkPipelineStageFlags OF_ANY_QUEUE =
    VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT | VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT |
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT |
    VK_PIPELINE_STAGE_HOST_BIT | VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;

/// The loader's functions, with an eye on the barriers.
struct Barriers {
    static inline PFN_vkGetDeviceProcAddr find_device;
    static inline PFN_vkCmdPipelineBarrier barrier;
    static inline int count;
    static inline VkPipelineStageFlags stages;

    static VKAPI_ATTR void VKAPI_CALL watched(VkCommandBuffer commands, VkPipelineStageFlags from,
                                              VkPipelineStageFlags to, VkDependencyFlags flags,
                                              std::uint32_t memories, const VkMemoryBarrier* memory,
                                              std::uint32_t buffers,
                                              const VkBufferMemoryBarrier* buffer,
                                              std::uint32_t images,
                                              const VkImageMemoryBarrier* image) {
        ++count;
        stages |= from | to;
        barrier(commands, from, to, flags, memories, memory, buffers, buffer, images, image);
    }
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_device(VkDevice device, const char* name) {
        const auto found = find_device(device, name);
        if (std::string(name) != "vkCmdPipelineBarrier") return found;
        barrier = reinterpret_cast<PFN_vkCmdPipelineBarrier>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(watched);
    }
    static inline PFN_vkGetInstanceProcAddr find;
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL of_instance(VkInstance instance,
                                                                const char* name) {
        const auto found = find(instance, name);
        if (std::string(name) != "vkGetDeviceProcAddr") return found;
        find_device = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(of_device);
    }
};

TEST(ComputeQueue, NeedsNoStageOfGraphics) {
    Barriers::find = value_of(host::Gpu::create()).get_instance_proc_addr();
    host::Gpu gpu = value_of(host::Gpu::create({.get_instance_proc_addr = Barriers::of_instance}));
    const auto environment =
        value_of(host::upload_environment(gpu, even_panorama(64, 32, 1, 1, 1), 16));
    for (const host::PrefilterMethod method :
         {host::PrefilterMethod::chain, host::PrefilterMethod::importance,
          host::PrefilterMethod::filtered_importance, host::PrefilterMethod::exact})
        value_of(host::prefilter(
            gpu, environment, {.method = method, .samples = 4, .exponents = {1, 64}, .width = 4}));
    for (const SphereMethod method :
         {SphereMethod::sh2, SphereMethod::kurt2019, SphereMethod::two_tap}) {
        host::RenderSettings settings{.method = method};
        settings.view.material = {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 64};
        settings.view.width = settings.view.height = 4;
        value_of(host::render(gpu, environment, settings));
    }
    EXPECT_GT(Barriers::count, 50);
    EXPECT_EQ(Barriers::stages & ~OF_ANY_QUEUE, 0u);
}

} // namespace
} // namespace lobelia::test
