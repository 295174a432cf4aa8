// A larger engine: light that changes while it is drawn by. A compute queue of its own makes the
// maps, so many bytes a frame, in one of two sets while the other is shown; timeline semaphores
// order the queues, and what they read passes from one family to the other. Ends with the sky, as
// `lobelia render` shows it.
#include <cstdio>
#include <vector>

#include "lighting.h"

namespace {

constexpr std::uint64_t BYTES_A_FRAME = 4 << 20; // that passes read and write

struct Timeline {
    VkSemaphore semaphore = VK_NULL_HANDLE;

    static Timeline create(VkDevice device) {
        const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                             .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
        const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO,
                                         .pNext = &type};
        Timeline timeline;
        check(vkCreateSemaphore(device, &info, nullptr, &timeline.semaphore), "make a semaphore");
        return timeline;
    }
    void wait(VkDevice device, std::uint64_t value) const {
        const VkSemaphoreWaitInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                       .semaphoreCount = 1,
                                       .pSemaphores = &semaphore,
                                       .pValues = &value};
        check(vkWaitSemaphores(device, &info, UINT64_MAX), "wait for a semaphore");
    }
    VkSemaphoreSubmitInfo at(std::uint64_t value) const {
        return {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                .semaphore = semaphore,
                .value = value,
                .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    }
};

void submit(VkQueue queue, VkCommandBuffer commands, const VkSemaphoreSubmitInfo& wait,
            const VkSemaphoreSubmitInfo& signal) {
    check(vkEndCommandBuffer(commands), "end a command buffer");
    const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                           .commandBuffer = commands};
    const VkSubmitInfo2 info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                             .waitSemaphoreInfoCount = 1,
                             .pWaitSemaphoreInfos = &wait,
                             .commandBufferInfoCount = 1,
                             .pCommandBufferInfos = &buffer,
                             .signalSemaphoreInfoCount = 1,
                             .pSignalSemaphoreInfos = &signal};
    check(vkQueueSubmit2(queue, 1, &info, VK_NULL_HANDLE), "submit commands");
}

// Light without a feature.
void record_grey(VkCommandBuffer commands, VkImage cube) {
    const VkClearColorValue grey{.float32 = {0.5f, 0.5f, 0.5f, 1}};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 6};
    transition(commands, cube, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    vkCmdClearColorImage(commands, cube, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &grey, 1, &all);
    transition(commands, cube, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

/// Light under construction or on show.
struct Set {
    Lighting lighting;
    lobelia::SphereJob sphere;
    std::uint64_t last_shown = 0; // frame

    /// Half of a change of owner, recorded by both queues: what the maps were before they are made
    /// anew is discarded, so they need no way back.
    void change_owner(VkCommandBuffer commands, std::uint32_t from, std::uint32_t to) const {
        if (from == to) return; // the semaphore is enough
        std::vector<VkImageMemoryBarrier2> images;
        for (const Image& image :
             {lighting.cube, lighting.diffuse, lighting.ladder, lighting.tables})
            images.push_back({.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                              .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                              .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                              .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                              .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT,
                              .oldLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                              .newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                              .srcQueueFamilyIndex = from,
                              .dstQueueFamilyIndex = to,
                              .image = image.handle,
                              .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0,
                                                   VK_REMAINING_ARRAY_LAYERS}});
        const VkBufferMemoryBarrier2 state{.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                                           .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                           .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                           .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                           .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT,
                                           .srcQueueFamilyIndex = from,
                                           .dstQueueFamilyIndex = to,
                                           .buffer = lighting.state.handle,
                                           .size = VK_WHOLE_SIZE};
        const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                    .bufferMemoryBarrierCount = 1,
                                    .pBufferMemoryBarriers = &state,
                                    .imageMemoryBarrierCount = std::uint32_t(images.size()),
                                    .pImageMemoryBarriers = images.data()};
        vkCmdPipelineBarrier2(commands, &info);
    }
};

struct Renderer {
    Engine graphics, compute; // one device, two queues if it has them
    Timeline drawn, made;     // by frame
    Canvas canvas;
    std::uint64_t frame = 0;
    Set* shown = nullptr;
    std::vector<float> first; // picture by `shown`

    void draw(bool is_new) {
        const VkCommandBuffer commands = graphics.begin();
        if (is_new) shown->change_owner(commands, compute.family, graphics.family);
        canvas.begin(commands);
        shown->sphere.record(commands, default_view());
        canvas.end(commands);
        canvas.read_back(commands);
        submit(graphics.queue, commands, made.at(is_new ? frame : 0), drawn.at(frame));
        shown->last_shown = frame;
        drawn.wait(graphics.device, frame); // to look at it
        const float* const pixels = static_cast<const float*>(canvas.pixels.data);
        const std::vector<float> picture(pixels, pixels + 4 * canvas.width * canvas.height);
        if (is_new && picture == first) fail("draw by the new light");
        if (!is_new && picture != first) fail("draw by the old light while there is no new one");
        first = picture;
    }

    /// Makes the light of `target`, grey or the sky's, frame by frame, and then shows it.
    void change_light(Set& target, bool sky) {
        const lobelia::PrefilterPlan& plan = target.lighting.plan;
        for (std::uint32_t next = 0; next < plan.pass_count();) {
            ++frame;
            const VkCommandBuffer commands = compute.begin();
            if (next == 0) {
                target.lighting.record_environment(commands);
                if (!sky) record_grey(commands, target.lighting.cube.handle);
            }
            // [budget]
            std::uint64_t bytes = 0;
            const std::uint32_t begin = next;
            while (next < plan.pass_count() && bytes < BYTES_A_FRAME) {
                const lobelia::PrefilterPass pass = plan.pass(next++);
                bytes += pass.bytes_read + pass.bytes_written;
            }
            target.lighting.prefilter.record(commands, begin, next - begin);
            // [budget]
            if (next == plan.pass_count())
                target.change_owner(commands, compute.family, graphics.family);
            submit(compute.queue, commands, drawn.at(target.last_shown), made.at(frame));
            if (next == plan.pass_count()) break;
            if (shown) draw(false);
        }
        shown = &target;
        draw(true);
    }
};

// A family for compute alone, where there is one; else the one for everything.
std::uint32_t compute_family(const Engine& engine) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(engine.physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(engine.physical, &count, families.data());
    for (std::uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & (VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT)) ==
            VK_QUEUE_COMPUTE_BIT)
            return i;
    return engine.family;
}

void run(const Engine& graphics, const Engine& compute, const char* path) {
    const lobelia::Device device{graphics.device, vkGetDeviceProcAddr};
    const auto sphere = expect(lobelia::Sphere::create(device, {.format = Canvas::FORMAT},
                                                       {.method = lobelia::SphereMethod::two_tap}));
    const auto make_set = [&] {
        const Lighting lighting = Lighting::create(graphics, device, 64, 64);
        return Set{lighting, expect(sphere.bind(lighting.sphere_sources()))};
    };
    Set sets[] = {make_set(), make_set()};
    const lobelia::SphereView view = default_view();
    Renderer renderer{graphics, compute, Timeline::create(graphics.device),
                      Timeline::create(graphics.device),
                      Canvas::create(graphics, view.width, view.height)};
    for (std::size_t change = 0; change < 4; ++change)
        renderer.change_light(sets[change % 2], change % 2 == 1);
    renderer.canvas.write(path);
    std::printf("%u frames, queue families %u and %u\n", unsigned(renderer.frame), graphics.family,
                compute.family);

    vkDeviceWaitIdle(graphics.device);
    vkDestroySemaphore(graphics.device, renderer.drawn.semaphore, nullptr);
    vkDestroySemaphore(graphics.device, renderer.made.semaphore, nullptr);
    renderer.canvas.destroy(graphics);
    for (const Set& set : sets) set.lighting.destroy(graphics);
}

} // namespace

int main(int, char** arguments) {
    VkPhysicalDeviceVulkan13Features newer{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .synchronization2 = true,
        .dynamicRendering = true};
    const VkPhysicalDeviceVulkan12Features features{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
        .pNext = &newer,
        .timelineSemaphore = true};
    Engine graphics = Engine::create(VK_API_VERSION_1_3, &features, compute_family);
    Engine compute = graphics;
    compute.family = compute_family(graphics);
    vkGetDeviceQueue(compute.device, compute.family, 0, &compute.queue);
    compute.make_pool();
    run(graphics, compute, arguments[1]);
    vkDestroyCommandPool(compute.device, compute.pool, nullptr);
    graphics.destroy();
}
