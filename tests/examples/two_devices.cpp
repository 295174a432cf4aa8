// Two devices in one process, and two threads on each: the library keeps nothing outside its
// objects. Everything is created, bound and recorded at once, and all four pictures are the same.
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include "lighting.h"

namespace {

/// What one thread makes.
struct Picture {
    Lighting lighting;
    Canvas canvas;
    lobelia::SphereJob sphere;
    VkCommandBuffer commands;

    static Picture record(const Engine& engine, const lobelia::Device& device) {
        const lobelia::SphereView view = default_view();
        const Lighting lighting = Lighting::create(engine, device, 64, 64);
        const Canvas canvas = Canvas::create(engine, view.width, view.height);
        const auto sphere = expect(lobelia::Sphere::create(
            device, {.format = Canvas::FORMAT}, {.method = lobelia::SphereMethod::two_tap}));
        const auto job = expect(sphere.bind(lighting.sphere_sources()));
        const VkCommandBuffer commands = engine.begin();
        lighting.record(commands);
        canvas.begin(commands);
        job.record(commands, view);
        canvas.end(commands);
        canvas.read_back(commands);
        return {lighting, canvas, job, commands};
    }
};

VkPipelineCache make_cache(const Engine& engine) {
    const VkPipelineCacheCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    VkPipelineCache cache = VK_NULL_HANDLE;
    check(vkCreatePipelineCache(engine.device, &info, nullptr, &cache), "create a cache");
    return cache;
}

} // namespace

int main(int, char** arguments) {
    const VkPhysicalDeviceVulkan13Features features{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, .dynamicRendering = true};
    std::vector<Engine> engines; // two threads of a device have a command pool each
    for (int device = 0; device < 2; ++device) {
        engines.push_back(Engine::create(VK_API_VERSION_1_3, &features));
        engines.push_back(engines.back());
        engines.back().make_pool();
    }
    const VkPipelineCache caches[] = {make_cache(engines[0]), make_cache(engines[2])};

    std::vector<std::unique_ptr<Picture>> pictures(engines.size());
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < engines.size(); ++i)
        threads.emplace_back([&, i] {
            const lobelia::Device device{engines[i].device, vkGetDeviceProcAddr, caches[i / 2]};
            pictures[i] = std::make_unique<Picture>(Picture::record(engines[i], device));
        });
    for (std::thread& thread : threads) thread.join();

    for (std::size_t i = 0; i < engines.size(); ++i)
        engines[i].submit_and_wait(pictures[i]->commands);
    const Canvas& first = pictures[0]->canvas;
    first.write(arguments[1]);
    for (const auto& picture : pictures)
        if (std::memcmp(first.pixels.data, picture->canvas.pixels.data,
                        std::size_t(16) * first.width * first.height) != 0)
            fail("draw the same picture from each thread");

    for (std::size_t i = 0; i < engines.size(); ++i) {
        pictures[i]->canvas.destroy(engines[i]);
        pictures[i]->lighting.destroy(engines[i]);
        pictures[i].reset();
        vkDestroyCommandPool(engines[i].device, engines[i].pool, nullptr);
    }
    for (int device = 0; device < 2; ++device) {
        vkDestroyPipelineCache(engines[2 * device].device, caches[device], nullptr);
        engines[2 * device].pool = VK_NULL_HANDLE;
        engines[2 * device].destroy();
    }
}
