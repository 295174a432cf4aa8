// What planning, creating, binding and recording cost an engine: medians of process CPU time, and
// the heap memory that stays, the driver's included.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include <malloc.h>

#include "lighting.h"

namespace {

constexpr int RUNS = 9;

/// Runs `work` several times and prints what one run costs; gives the last result.
template <class Work>
auto cost(const char* name, Work work) {
    std::vector<double> times;
    const auto heap = [] { return double(mallinfo2().uordblks) / 1024; };
    for (int run = 1; run < RUNS; ++run) {
        const std::clock_t begin = std::clock();
        work();
        times.push_back(double(std::clock() - begin) * 1e3 / CLOCKS_PER_SEC);
    }
    const double before = heap();
    const std::clock_t begin = std::clock();
    auto result = work();
    times.push_back(double(std::clock() - begin) * 1e3 / CLOCKS_PER_SEC);
    std::sort(times.begin(), times.end());
    std::printf("%-22s %9.3f ms %9.1f KiB\n", name, times[RUNS / 2], heap() - before);
    return result;
}

void measure(const Engine& engine) {
    const lobelia::Device device{engine.device, vkGetDeviceProcAddr};
    const Lighting lighting = Lighting::create(engine, device, 64, 64);
    const lobelia::PrefilterPlan& plan = lighting.plan;
    const std::uint32_t map = plan.maps()[0].size, rung = plan.ladder_size();
    const VkFormat half = VK_FORMAT_R16G16B16A16_SFLOAT;
    const lobelia::CubeMap source{lighting.cube.handle, VK_FORMAT_R32G32B32A32_SFLOAT,
                                  Lighting::FACE};
    const lobelia::CubeMap maps[] = {{lighting.diffuse.handle, half, map}};
    const auto ladder = lobelia::ladder_for(lobelia::Taps::two, 64, 64);

    std::printf("of a ladder of %u rungs of %u texels and Lambert's map of %u, by %u passes\n",
                plan.ladder().rungs, rung, map, plan.pass_count());
    cost("PrefilterPlan::make", [&] {
        return expect(lobelia::PrefilterPlan::make(
            {.lambert = true, .ladder = ladder, .source_size = Lighting::FACE}));
    });
    const auto prefilter =
        cost("Prefilter::create", [&] { return expect(lobelia::Prefilter::create(device)); });
    const auto job = cost("Prefilter::bind", [&] {
        return expect(prefilter.bind(plan, source, maps, lighting.scratch.handle,
                                     lighting.state.handle, lighting.ladder.handle));
    });
    cost("PrefilterJob::record", [&] {
        const VkCommandBuffer commands = engine.begin();
        job.record(commands, 0, plan.pass_count());
        check(vkEndCommandBuffer(commands), "end a command buffer");
        vkFreeCommandBuffers(engine.device, engine.pool, 1, &commands);
        return 0;
    });
    const auto sphere = cost("Sphere::create", [&] {
        return expect(lobelia::Sphere::create(device, {.format = Canvas::FORMAT},
                                              {.method = lobelia::SphereMethod::two_tap}));
    });
    cost("Sphere::bind", [&] { return expect(sphere.bind(lighting.sphere_sources())); });
    const auto kib = [](std::uint64_t texels, std::uint64_t bytes) {
        return double(texels * bytes) / 1024;
    };
    std::printf("memory, KiB: cube map %.0f, Lambert's map %.0f, ladder %.0f, scratch %.0f, state "
                "%.1f\n",
                kib(6 * Lighting::FACE * Lighting::FACE, 16), kib(6 * map * map, 8),
                kib(6ull * plan.ladder().rungs * rung * rung, 8), kib(plan.scratch_size(), 1),
                kib(plan.state_size(), 1));
    lighting.destroy(engine);
}

} // namespace

int main() {
    const VkPhysicalDeviceVulkan13Features features{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, .dynamicRendering = true};
    Engine engine = Engine::create(VK_API_VERSION_1_3, &features);
    measure(engine);
    engine.destroy();
}
