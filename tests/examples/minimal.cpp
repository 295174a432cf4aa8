// A minimal engine: shades the sphere under the sky, as `lobelia render` does.
#include <lobelia/requirements.h>
#include <lobelia/sphere.h>

#include "lighting.h"

namespace {

// [lend]
lobelia::Device lend(const Engine& engine) {
    const auto asked =
        expect(lobelia::requirements(engine.instance, engine.physical, vkGetInstanceProcAddr));
    if (const lobelia::Requirement* lacking = asked.lacking()) fail(lacking->what);
    return {.handle = engine.device, .get_device_proc_addr = vkGetDeviceProcAddr};
}
// [lend]

// [draw]
void draw(const Engine& engine, const char* path) {
    const lobelia::Device device = lend(engine);
    const lobelia::SphereView view = default_view();
    const Lighting lighting = Lighting::create(engine, device, 64, 64);
    const Canvas canvas = Canvas::create(engine, view.width, view.height);
    const auto sphere = expect(lobelia::Sphere::create(device, {.format = Canvas::FORMAT},
                                                       {.method = lobelia::SphereMethod::two_tap}));
    const auto job = expect(sphere.bind(lighting.sphere_sources()));

    const VkCommandBuffer commands = engine.begin();
    lighting.record(commands);
    canvas.begin(commands);
    job.record(commands, view);
    canvas.end(commands);
    canvas.read_back(commands);
    engine.submit_and_wait(commands);
    canvas.write(path);
    canvas.destroy(engine);
    lighting.destroy(engine);
}
// [draw]

} // namespace

int main(int, char** arguments) {
    const VkPhysicalDeviceVulkan13Features features{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, .dynamicRendering = true};
    Engine engine = Engine::create(VK_API_VERSION_1_3, &features);
    draw(engine, arguments[1]); // what Lobelia made goes before the device
    engine.destroy();
}
