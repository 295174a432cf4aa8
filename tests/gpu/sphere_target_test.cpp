#include <cstring>
#include <vector>

#include <vulkan/vulkan.h>

#include "sphere_fixture.h"

// The sphere in a render pass and in dynamic rendering. The device is the host's own, but for what
// its creation asks for.
namespace lobelia::test {
namespace {

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical_device,
                                             const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator,
                                             VkDevice* device) {
    const char* const extensions[] = {VK_KHR_CREATE_RENDERPASS_2_EXTENSION_NAME,
                                      VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME,
                                      VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME};
    VkPhysicalDeviceDynamicRenderingFeatures rendering{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES,
        .dynamicRendering = VK_TRUE};
    VkDeviceCreateInfo with_rendering = *info;
    with_rendering.pNext = &rendering;
    with_rendering.enabledExtensionCount = std::uint32_t(std::size(extensions));
    with_rendering.ppEnabledExtensionNames = extensions;
    return vkCreateDevice(physical_device, &with_rendering, allocator, device);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_proc(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkCreateDevice") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&create_device);
    return vkGetInstanceProcAddr(instance, name);
}

class SphereTargetTest : public testing::Test {
protected:
    host::Gpu gpu =
        value_of(host::Gpu::create({.validation = true, .get_instance_proc_addr = &get_proc}));

    void TearDown() override {
        for (const std::string& message : gpu.take_messages()) ADD_FAILURE() << message;
    }

    template <class Function>
    Function function(const char* name) const {
        const Device& device = gpu.device();
        return reinterpret_cast<Function>(device.get_device_proc_addr(device.handle, name));
    }

    host::Image draw_dynamically(const SphereSources& sources, const SphereView& view) {
        const VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
        const host::GpuImage target = value_of(gpu.create_image(
            {.format = format,
             .width = view.width,
             .height = view.height,
             .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
        const Sphere sphere = value_of(Sphere::create(gpu.device(), {.format = format}, {}));
        const SphereJob job = value_of(sphere.bind(sources));
        const VkRenderingAttachmentInfo attachment{
            .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = target.view(),
            .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
            .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
        const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                        .renderArea = {{0, 0}, {view.width, view.height}},
                                        .layerCount = 1,
                                        .colorAttachmentCount = 1,
                                        .pColorAttachments = &attachment};
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            record_layout_change(gpu, commands, target, VK_IMAGE_LAYOUT_UNDEFINED,
                                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
            function<PFN_vkCmdBeginRenderingKHR>("vkCmdBeginRenderingKHR")(commands, &rendering);
            job.record(commands, view);
            function<PFN_vkCmdEndRenderingKHR>("vkCmdEndRenderingKHR")(commands);
            record_layout_change(gpu, commands, target, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        }));
        return value_of(gpu.download(target, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL));
    }
};

TEST_F(SphereTargetTest, GetsTheSameBitsEitherWay) {
    const host::GpuImage cube = on_device(gpu, image_of(random_cube(oracle::Scene::noise, 8, 5)));
    const SphereSources sources{
        .background = cube.view(), .diffuse = cube.view(), .specular = cube.view()};
    const SphereView view{.material = grey(0.5f, 0.5f, 16.0f), .width = 40, .height = 30};
    const host::Image passed = SpherePicture(gpu, 40, 30, {}).draw(sources, view);
    const host::Image dynamic = draw_dynamically(sources, view);
    ASSERT_EQ(passed.texels.size(), dynamic.texels.size());
    EXPECT_EQ(std::memcmp(passed.texels.data(), dynamic.texels.data(),
                          passed.texels.size() * sizeof(float)),
              0);
}

TEST_F(SphereTargetTest, RefusesToStartWithoutATargetOrSources) {
    const auto none = Sphere::create(gpu.device(), {}, {});
    ASSERT_FALSE(none);
    EXPECT_STREQ(none.error().step, "SphereTarget needs a render pass or a format");

    const Sphere sphere =
        value_of(Sphere::create(gpu.device(), {.format = VK_FORMAT_R32G32B32A32_SFLOAT}, {}));
    const auto unbound = sphere.bind({});
    ASSERT_FALSE(unbound);
    EXPECT_STREQ(unbound.error().step, "SphereSources lacks what the shading reads");

    const SphereTarget target{.format = VK_FORMAT_R32G32B32A32_SFLOAT};
    for (const std::uint32_t samples : {0u, SphereShading::MOST_SAMPLES + 1}) {
        const auto sampled = Sphere::create(gpu.device(), target, {.samples = samples});
        ASSERT_FALSE(sampled);
        EXPECT_STREQ(sampled.error().step, "SphereShading takes 1 to 1024 samples");
    }
    const auto unknown = Sphere::create(gpu.device(), target, {.method = SphereMethod(99)});
    ASSERT_FALSE(unknown);
    EXPECT_STREQ(unknown.error().step, "SphereShading has no such method");
}

} // namespace
} // namespace lobelia::test
