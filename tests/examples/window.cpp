// A window by GLFW and Vulkan by vulkan.hpp's RAII classes: the sphere, a few frames of it.
#include "window_engine.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

#include <lobelia/clipped_tables.h>
#include <lobelia/panorama.h>
#include <lobelia/prefilter.h>
#include <lobelia/sky.h>
#include <lobelia/sphere.h>

namespace {

using window::Buffer, window::Engine, window::Image, window::SIZE;
constexpr std::uint32_t FACE = 256, FRAMES = 3;

template <class Value>
Value expect(lobelia::Result<Value> result) {
    if (!result) throw std::runtime_error(result.error().step);
    return *std::move(result);
}

void transition(const vk::raii::CommandBuffer& commands, vk::Image image, vk::ImageLayout from,
                vk::ImageLayout to) {
    const vk::ImageMemoryBarrier barrier{
        .srcAccessMask = vk::AccessFlagBits::eMemoryWrite,
        .dstAccessMask = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image,
        .subresourceRange = {vk::ImageAspectFlagBits::eColor, 0, 1, 0, VK_REMAINING_ARRAY_LAYERS}};
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands,
                             vk::PipelineStageFlagBits::eAllCommands, {}, {}, {}, barrier);
}

void write(const char* path, const float* rgba) {
    std::FILE* const file = std::fopen(path, "wb");
    if (!file) throw std::runtime_error("cannot write the picture");
    std::fprintf(file, "PF\n%u %u\n-1.0\n", SIZE, SIZE);
    for (std::uint32_t y = SIZE; y-- > 0;)
        for (std::uint32_t x = 0; x < SIZE; ++x)
            std::fwrite(rgba + 4 * (y * SIZE + x), sizeof(float), 3, file);
    std::fclose(file);
}

void run(const Engine& engine, const char* path) {
    using Layout = vk::ImageLayout;
    const lobelia::Device device{.handle = *engine.device,
                                 .get_device_proc_addr =
                                     engine.device.getDispatcher()->vkGetDeviceProcAddr};
    const auto plan = expect(
        lobelia::PrefilterPlan::make({.lambert = true,
                                      .ladder = lobelia::ladder_for(lobelia::Taps::two, 64, 64),
                                      .source_size = FACE}));

    const auto half = vk::Format::eR16G16B16A16Sfloat, whole = vk::Format::eR32G32B32A32Sfloat;
    const std::uint32_t map = plan.maps()[0].size, rung = plan.ladder_size();
    using View = vk::ImageViewType;
    const Image panorama = engine.image(whole, {4 * FACE, 2 * FACE}, 1, View::e2D);
    const Image cube = engine.image(whole, {FACE, FACE}, 6, View::eCube);
    const Image diffuse = engine.image(half, {map, map}, 6, View::eCube);
    const Image ladder = engine.image(half, {rung, rung}, 6 * plan.ladder().rungs, View::e2DArray);
    const Image tables =
        engine.image(half, {lobelia::ClippedTables::WIDTH, lobelia::ClippedTables::HEIGHT},
                     lobelia::ClippedTables::LAYERS, View::e2DArray,
                     Engine::Usage::eSampled | Engine::Usage::eTransferDst);
    const Image picture =
        engine.image(whole, {SIZE, SIZE}, 1, View::e2D,
                     Engine::Usage::eColorAttachment | Engine::Usage::eTransferSrc);
    using Use = vk::BufferUsageFlagBits;
    const Buffer scratch =
        engine.buffer(plan.scratch_size(), Use::eStorageBuffer | Use::eUniformTexelBuffer);
    const Buffer state =
        engine.buffer(plan.state_size(), Use::eStorageBuffer | Use::eUniformBuffer);
    const Buffer upload =
        engine.buffer(lobelia::ClippedTables::BUFFER_BYTES, Use::eTransferSrc | Use::eTransferDst);
    const Buffer pixels = engine.buffer(SIZE * SIZE * 16, Use::eTransferDst);

    const auto WHOLE = VK_FORMAT_R32G32B32A32_SFLOAT, HALF = VK_FORMAT_R16G16B16A16_SFLOAT;
    const lobelia::CubeMap source{*cube.handle, WHOLE, FACE};
    const lobelia::CubeMap maps[] = {{*diffuse.handle, HALF, map}};
    const auto sky = expect(expect(lobelia::Sky::create(device))
                                .bind({*panorama.handle, *panorama.view, 4 * FACE, 2 * FACE}));
    const auto resample = expect(expect(lobelia::PanoramaToCube::create(device))
                                     .bind({*panorama.handle, WHOLE, 4 * FACE, 2 * FACE}, source));
    const auto prefilter =
        expect(expect(lobelia::Prefilter::create(device))
                   .bind(plan, source, maps, *scratch.handle, *state.handle, *ladder.handle));
    const auto clipped = expect(lobelia::ClippedTables::create(device));
    const auto sphere =
        expect(expect(lobelia::Sphere::create(device, {.format = WHOLE},
                                              {.method = lobelia::SphereMethod::two_tap}))
                   .bind({.background = *cube.view,
                          .diffuse = *diffuse.view,
                          .prefilter_state = *state.handle,
                          .ladder = *ladder.view,
                          .clipped_tables = *tables.view}));

    const auto targets = engine.swapchain.getImages();
    for (std::uint32_t frame = 0; frame < FRAMES; ++frame) {
        glfwPollEvents();
        const auto [code, index] =
            engine.swapchain.acquireNextImage(UINT64_MAX, *engine.acquired, nullptr);
        const auto buffers = vk::raii::CommandBuffers(
            engine.device,
            vk::CommandBufferAllocateInfo{.commandPool = *engine.pool, .commandBufferCount = 1});
        const auto& commands = buffers.front();
        commands.begin({});
        if (frame == 0) {
            sky.record(*commands);
            resample.record(*commands);
            prefilter.record(*commands, 0, plan.pass_count());
            clipped.record(*commands, *upload.handle, *tables.handle);
        }
        transition(commands, *picture.handle, Layout::eUndefined, Layout::eColorAttachmentOptimal);
        const vk::RenderingAttachmentInfo colour{.imageView = *picture.view,
                                                 .imageLayout = Layout::eColorAttachmentOptimal,
                                                 .loadOp = vk::AttachmentLoadOp::eDontCare,
                                                 .storeOp = vk::AttachmentStoreOp::eStore};
        commands.beginRendering({.renderArea = {{0, 0}, {SIZE, SIZE}},
                                 .layerCount = 1,
                                 .colorAttachmentCount = 1,
                                 .pColorAttachments = &colour});
        sphere.record(*commands, {.material = {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 64},
                                  .width = SIZE,
                                  .height = SIZE});
        commands.endRendering();
        transition(commands, *picture.handle, Layout::eColorAttachmentOptimal,
                   Layout::eTransferSrcOptimal);
        transition(commands, targets[index], Layout::eUndefined, Layout::eTransferDstOptimal);
        const vk::ImageSubresourceLayers all{vk::ImageAspectFlagBits::eColor, 0, 0, 1};
        const std::array corners{vk::Offset3D{0, 0, 0}, vk::Offset3D{SIZE, SIZE, 1}};
        commands.blitImage(*picture.handle, Layout::eTransferSrcOptimal, targets[index],
                           Layout::eTransferDstOptimal, vk::ImageBlit{all, corners, all, corners},
                           vk::Filter::eNearest);
        transition(commands, targets[index], Layout::eTransferDstOptimal, Layout::ePresentSrcKHR);
        commands.copyImageToBuffer(
            *picture.handle, Layout::eTransferSrcOptimal, *pixels.handle,
            vk::BufferImageCopy{.imageSubresource = all, .imageExtent = {SIZE, SIZE, 1}});
        commands.pipelineBarrier(
            vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {},
            vk::MemoryBarrier{.srcAccessMask = vk::AccessFlagBits::eTransferWrite,
                              .dstAccessMask = vk::AccessFlagBits::eHostRead},
            {}, {});
        commands.end();
        const vk::PipelineStageFlags before = vk::PipelineStageFlagBits::eAllCommands;
        engine.queue.submit(vk::SubmitInfo{.waitSemaphoreCount = 1,
                                           .pWaitSemaphores = &*engine.acquired,
                                           .pWaitDstStageMask = &before,
                                           .commandBufferCount = 1,
                                           .pCommandBuffers = &*commands,
                                           .signalSemaphoreCount = 1,
                                           .pSignalSemaphores = &*engine.drawn});
        if (engine.queue.presentKHR({.waitSemaphoreCount = 1,
                                     .pWaitSemaphores = &*engine.drawn,
                                     .swapchainCount = 1,
                                     .pSwapchains = &*engine.swapchain,
                                     .pImageIndices = &index}) != vk::Result::eSuccess)
            throw std::runtime_error("the window was changed");
        engine.queue.waitIdle();
    }
    write(path, static_cast<const float*>(pixels.memory.mapMemory(0, VK_WHOLE_SIZE)));
}

} // namespace

int main(int, char** arguments) {
    try {
        const Engine engine;
        run(engine, arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
