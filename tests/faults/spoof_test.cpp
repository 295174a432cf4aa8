#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <lobelia/host/work.h>

#include "support/environments.h"
#include "support/gpu_sources.h"
#include "vulkan_shim.h"

// Devices that can less than the one at hand: what they cannot do is done another way, or refused.
namespace lobelia::test {
namespace {

class SpoofTest : public testing::Test {
protected:
    VulkanShim& shim = VulkanShim::get();
    const host::Image light = image_of(oracle::random_cube(oracle::Scene::noise, 16, 5));

    host::Gpu open() {
        return value_of(host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()}));
    }
    void TearDown() override { shim.spoof = {}; }
};

std::string message_of(const auto& outcome) {
    return outcome ? "" : outcome.error().message;
}

TEST_F(SpoofTest, WithoutTimestampsOnlyTheDevicesTimesAreMissing) {
    shim.spoof.queue_family = [](VkQueueFamilyProperties& family) {
        family.timestampValidBits = 0;
    };
    auto gpu = open();
    const auto environment = value_of(host::upload_environment(gpu, light));
    const auto filtered =
        value_of(host::prefilter(gpu, environment, {.exponents = {16.0f}, .width = 4}));
    for (const host::PassReport& pass : filtered.report.passes) {
        EXPECT_FALSE(pass.gpu_ms) << pass.name;
        EXPECT_TRUE(pass.cpu_ms) << pass.name;
    }
}

// Samples are then taken from halves: their rounding, 2^-11 of each texel, is all that changes.
TEST_F(SpoofTest, WithoutLinearFilteringOfFloatsSamplesComeFromHalves) {
    const host::PrefilterSettings settings{
        .method = host::PrefilterMethod::filtered_importance, .exponents = {16.0f}, .width = 4};
    const auto sampled = [&] {
        auto gpu = open();
        const auto environment = value_of(host::upload_environment(gpu, light));
        shim.audit.linear_floats.clear();
        return value_of(host::prefilter(gpu, environment, settings)).maps[0].texels;
    };
    const std::vector<float> expected = sampled();
    EXPECT_FALSE(shim.audit.linear_floats.empty());
    shim.spoof.format = [](VkFormat format, VkFormatProperties& properties) {
        if (format == VK_FORMAT_R32G32B32A32_SFLOAT)
            properties.optimalTilingFeatures &=
                ~VkFormatFeatureFlags(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT);
    };
    const std::vector<float> found = sampled();
    EXPECT_TRUE(shim.audit.linear_floats.empty()) << *shim.audit.linear_floats.begin();
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i] / expected[i], 1.0f, 0x1p-10f) << i;
}

TEST_F(SpoofTest, TheLeastLimitsAreKept) {
    shim.spoof.properties = [](VkPhysicalDeviceProperties& properties) {
        properties.apiVersion = VK_API_VERSION_1_1;
        properties.limits.maxImageDimension2D = 4096;
        properties.limits.maxImageDimensionCube = 4096;
        properties.limits.maxFramebufferWidth = 4096;
        properties.limits.maxFramebufferHeight = 4096;
        properties.limits.maxViewportDimensions[0] = 4096;
        properties.limits.maxViewportDimensions[1] = 4096;
    };
    auto gpu = open();
    const auto environment = value_of(host::upload_environment(gpu, light));
    const SphereView large{.material = {{0.5f, 0.5f, 0.5f}, {}, 1.0f}, .width = 4097, .height = 1};
    EXPECT_NE(message_of(host::render(gpu, environment, {.view = large})).find("4096"),
              std::string::npos);
    EXPECT_NE(message_of(gpu.create_image({.width = 4097, .layers = 6, .cube = true})).find("4096"),
              std::string::npos);
    const SphereView small{.material = {{0.5f, 0.5f, 0.5f}, {}, 1.0f}, .width = 4, .height = 4};
    EXPECT_EQ(message_of(host::render(gpu, environment, {.view = small})), "");
}

TEST_F(SpoofTest, WithoutItsKindOfMemoryADeviceIsRefused) {
    shim.spoof.memory = [](VkPhysicalDeviceMemoryProperties& memory) {
        memory.memoryTypeCount = 0;
    };
    auto gpu = open();
    EXPECT_NE(message_of(host::upload_environment(gpu, light)).find("memory"), std::string::npos);
}

TEST_F(SpoofTest, WhatIsLargerThanAHeapIsRefusedAndNotAskedFor) {
    shim.spoof.memory = [](VkPhysicalDeviceMemoryProperties& memory) {
        for (VkMemoryHeap& heap : memory.memoryHeaps) heap.size = 1 << 16;
    };
    auto gpu = open();
    constexpr VkImageUsageFlags USAGE = VK_IMAGE_USAGE_SAMPLED_BIT;
    const auto small = value_of(gpu.create_image({.width = 32, .height = 32, .usage = USAGE}));
    shim.faults.begin();
    const std::size_t alive = shim.census.alive();
    EXPECT_NE(
        message_of(gpu.create_image({.width = 128, .height = 128, .usage = USAGE})).find("65536"),
        std::string::npos);
    EXPECT_NE(
        message_of(gpu.create_buffer(65537, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::host))
            .find("65536"),
        std::string::npos);
    EXPECT_EQ(std::ranges::count(shim.faults.calls(), Call::vkAllocateMemory), 0);
    EXPECT_EQ(shim.census.alive(), alive);
}

TEST_F(SpoofTest, AGpuTakesNoMoreMemoryThanItMay) {
    auto gpu = value_of(host::Gpu::create(
        {.get_instance_proc_addr = VulkanShim::entry(), .memory_bytes = 1 << 16}));
    const auto take = [&](VkDeviceSize bytes) {
        return gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::device);
    };
    {
        const auto half = value_of(take(1 << 15));
        EXPECT_NE(message_of(take((1 << 15) + 1)).find("32768 bytes of the 65536"),
                  std::string::npos);
        auto rest = value_of(take(1 << 15)); // what was refused has taken nothing
        EXPECT_FALSE(take(1));
        auto moved = std::move(rest);
        EXPECT_FALSE(take(1));
    }
    EXPECT_TRUE(take(1 << 16)); // all of it has come back
}

TEST_F(SpoofTest, WithoutAQueueForBothADeviceIsRefused) {
    shim.spoof.queue_family = [](VkQueueFamilyProperties& family) {
        family.queueFlags = VK_QUEUE_COMPUTE_BIT;
    };
    EXPECT_NE(message_of(host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()}))
                  .find("queue"),
              std::string::npos);
}

} // namespace
} // namespace lobelia::test
