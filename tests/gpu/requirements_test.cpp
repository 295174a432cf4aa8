#include <lobelia/requirements.h>

#include <algorithm>
#include <array>
#include <string>

#include <lobelia/prefilter.h>

#include "prefilter_plan.h"
#include "support/gpu_test.h"
#include "support/qualities.h"

// What an engine is told before there is a device.
namespace lobelia::test {
namespace {

class RequirementsTest : public GpuTest {};

TEST_F(RequirementsTest, AreKnownBeforeThereIsADevice) {
    const auto asked =
        requirements(gpu.instance(), gpu.physical_device(), gpu.get_instance_proc_addr());
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->lacking(), nullptr);
    for (const Requirement& requirement : asked->list) {
        EXPECT_STRNE(requirement.what, "");
        EXPECT_STRNE(requirement.use, "") << requirement.what;
    }
    EXPECT_FALSE(requirements(gpu.instance(), VK_NULL_HANDLE, gpu.get_instance_proc_addr()));
}

// The same device, worse.
struct Poorer {
    static inline PFN_vkGetInstanceProcAddr find;
    static inline VkInstance instance;
    static inline VkPhysicalDeviceProperties properties;
    static VKAPI_ATTR void VKAPI_CALL get_properties(VkPhysicalDevice,
                                                     VkPhysicalDeviceProperties* out) {
        *out = properties;
    }
    static VKAPI_ATTR void VKAPI_CALL get_formats(VkPhysicalDevice device, VkFormat format,
                                                  VkFormatProperties* out) {
        reinterpret_cast<PFN_vkGetPhysicalDeviceFormatProperties>(
            find(instance, "vkGetPhysicalDeviceFormatProperties"))(device, format, out);
        if (format == VK_FORMAT_R32G32B32A32_SFLOAT)
            out->optimalTilingFeatures &=
                ~VkFormatFeatureFlags(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT);
    }
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL proc(VkInstance from, const char* name) {
        const std::string wanted = name;
        if (wanted == "vkGetPhysicalDeviceProperties")
            return reinterpret_cast<PFN_vkVoidFunction>(get_properties);
        if (wanted == "vkGetPhysicalDeviceFormatProperties")
            return reinterpret_cast<PFN_vkVoidFunction>(get_formats);
        if (wanted.starts_with("vkGetPhysicalDeviceFeatures2"))
            return nullptr; // an instance of Vulkan 1.0
        return find(from, name);
    }
};

TEST_F(RequirementsTest, NameWhatAPoorerDeviceLacksAndWhatThatCosts) {
    Poorer::find = gpu.get_instance_proc_addr();
    Poorer::instance = gpu.instance();
    reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
        Poorer::find(gpu.instance(), "vkGetPhysicalDeviceProperties"))(gpu.physical_device(),
                                                                       &Poorer::properties);
    Poorer::properties.limits.maxTexelBufferElements = 65536;
    const auto asked = requirements(gpu.instance(), gpu.physical_device(), Poorer::proc);
    ASSERT_TRUE(asked);
    ASSERT_NE(asked->lacking(), nullptr);
    EXPECT_STREQ(asked->lacking()->use, "Prefilter of cube maps up to 256");
    const auto met = [&](const std::string& what) {
        const auto found = std::find_if(asked->list.begin(), asked->list.end(),
                                        [&](const Requirement& r) { return r.what == what; });
        return found != asked->list.end() && found->met;
    };
    EXPECT_FALSE(met("R32G32B32A32_SFLOAT images, filtered"));
    EXPECT_FALSE(met("dynamic rendering"));
    EXPECT_TRUE(met("a queue for graphics"));

    Poorer::properties.apiVersion = VK_API_VERSION_1_0;
    const auto older = requirements(gpu.instance(), gpu.physical_device(), Poorer::proc);
    ASSERT_TRUE(older);
    ASSERT_NE(older->lacking(), nullptr);
    EXPECT_STREQ(older->lacking()->what, "Vulkan 1.1");
}

// The texels, of 16 bytes, of the largest level that the prefilter reads.
VkDeviceSize largest_level(std::uint32_t source_size) {
    VkDeviceSize largest = 0;
    for (const Quality quality : QUALITIES)
        for (float exponent = 0.5f; exponent < 1e6f; exponent *= 4) {
            const std::array exponents = {exponent};
            const auto plan = PrefilterPlan::make({.exponents = exponents,
                                                   .lambert = true,
                                                   .ladder = {.lowest = 2, .rungs = 24},
                                                   .quality = quality,
                                                   .source_size = source_size});
            EXPECT_TRUE(plan);
            for (const ChainLevel& level : plan->state().levels)
                largest = std::max(largest, level.bytes() / 16);
        }
    return largest;
}

TEST(Requirements, GrantTheLargestLevelOfThePrefilter) {
    EXPECT_LE(largest_level(256), 1u << 21);
    EXPECT_GT(largest_level(256), 1u << 16); // that every device grants
    EXPECT_LE(largest_level(1024), 1u << 25);
}

} // namespace
} // namespace lobelia::test
