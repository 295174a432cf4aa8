#include <lobelia/device.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <vector>

#include <lobelia/prefilter.h>
#include <lobelia/sky.h>

#include "support/gpu_sources.h"
#include "support/gpu_test.h"

// What an engine may lend with its device.
namespace lobelia::test {
namespace {

class DeviceTest : public GpuTest {
protected:
    static inline std::vector<std::string> warnings;
    static void keep(const char* text, void*) noexcept { warnings.push_back(text); }
    void SetUp() override { warnings.clear(); }

    host::GpuImage make_cube(VkFormat format, std::uint32_t size, VkImageUsageFlags usage) {
        return value_of(gpu.create_image({.format = format,
                                          .width = size,
                                          .height = size,
                                          .layers = 6,
                                          .usage = usage,
                                          .cube = true}));
    }
    host::GpuBuffer make_buffer(VkDeviceSize bytes) {
        return value_of(gpu.create_buffer(bytes,
                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                              VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                              VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
                                          host::Memory::device));
    }
};

template <class Function>
Function device_function(const host::Gpu& gpu, const char* name) {
    return reinterpret_cast<Function>(gpu.device().get_device_proc_addr(gpu.device().handle, name));
}

TEST_F(DeviceTest, IsTakenOnlyByALibraryOfItsHeadersVersion) {
    EXPECT_EQ(library_version(), HEADER_VERSION);
    Device device = gpu.device();
    device.header_version = HEADER_VERSION + 1; // a later patch
    EXPECT_TRUE(Sky::create(device));
    device.header_version = HEADER_VERSION + 1000;
    const auto refused = Sky::create(device);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, VK_ERROR_VALIDATION_FAILED_EXT);
    EXPECT_STREQ(refused.error().step, "the headers are those of another version than the library");
}

// The driver's own functions, with a count of the labels and the names.
struct Labels {
    static inline PFN_vkGetDeviceProcAddr find;
    static inline PFN_vkCmdBeginDebugUtilsLabelEXT begin_label;
    static inline PFN_vkCmdEndDebugUtilsLabelEXT end_label;
    static inline PFN_vkSetDebugUtilsObjectNameEXT set_name;
    static inline std::map<std::string, int> begun;
    static inline std::map<std::string, int> named;
    static inline int open;

    static VKAPI_ATTR void VKAPI_CALL begin(VkCommandBuffer commands,
                                            const VkDebugUtilsLabelEXT* label) {
        ++begun[label->pLabelName];
        ++open;
        begin_label(commands, label);
    }
    static VKAPI_ATTR void VKAPI_CALL end(VkCommandBuffer commands) {
        --open;
        end_label(commands);
    }
    static VKAPI_ATTR VkResult VKAPI_CALL name(VkDevice device,
                                               const VkDebugUtilsObjectNameInfoEXT* info) {
        if (info->objectType == VK_OBJECT_TYPE_PIPELINE) ++named[info->pObjectName];
        return set_name(device, info);
    }
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL spy(VkDevice device, const char* name_of) {
        const std::string wanted = name_of;
        if (wanted == "vkCmdBeginDebugUtilsLabelEXT")
            return reinterpret_cast<PFN_vkVoidFunction>(begin);
        if (wanted == "vkCmdEndDebugUtilsLabelEXT")
            return reinterpret_cast<PFN_vkVoidFunction>(end);
        if (wanted == "vkSetDebugUtilsObjectNameEXT")
            return reinterpret_cast<PFN_vkVoidFunction>(name);
        return find(device, name_of);
    }
    // A device whose extension is not enabled.
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL lack(VkDevice device, const char* name_of) {
        return std::strstr(name_of, "DebugUtils") ? nullptr : find(device, name_of);
    }
};

TEST_F(DeviceTest, NamesPipelinesAndLabelsPassesWhereDebugUtilsAreEnabled) {
    Labels::find = gpu.device().get_device_proc_addr;
    Labels::begin_label =
        device_function<PFN_vkCmdBeginDebugUtilsLabelEXT>(gpu, "vkCmdBeginDebugUtilsLabelEXT");
    Labels::end_label =
        device_function<PFN_vkCmdEndDebugUtilsLabelEXT>(gpu, "vkCmdEndDebugUtilsLabelEXT");
    Labels::set_name =
        device_function<PFN_vkSetDebugUtilsObjectNameEXT>(gpu, "vkSetDebugUtilsObjectNameEXT");
    ASSERT_TRUE(Labels::begin_label && Labels::end_label && Labels::set_name);

    for (const bool enabled : {false, true}) {
        Labels::begun.clear();
        Labels::named.clear();
        Device device = gpu.device();
        device.get_device_proc_addr = Labels::spy;
        device.debug_utils = enabled;
        const auto sky = Sky::create(device);
        ASSERT_TRUE(sky);
        auto panorama = value_of(
            gpu.create_image({.width = 8,
                              .height = 4,
                              .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}));
        const auto job = sky->bind({panorama.handle(), panorama.view(), 8, 4});
        ASSERT_TRUE(job);
        value_of(gpu.submit([&](VkCommandBuffer commands) { job->record(commands); }));
        EXPECT_EQ(Labels::begun["lobelia sky"], int(enabled));
        EXPECT_EQ(Labels::named["lobelia sky"], int(enabled));
        EXPECT_EQ(Labels::open, 0);
    }
}

TEST_F(DeviceTest, WarnsWhereNamesAreAskedForAndCannotBe) {
    Labels::find = gpu.device().get_device_proc_addr;
    Device device = gpu.device();
    device.get_device_proc_addr = Labels::lack;
    device.debug_utils = true;
    device.on_warning = keep;
    EXPECT_TRUE(Sky::create(device));
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings[0].find("vkCmdBeginDebugUtilsLabelEXT"), std::string::npos) << warnings[0];
}

TEST_F(DeviceTest, WarnsOfASourceThatCutsSunsOffAndTimesEachPassInTheCallersPool) {
    constexpr std::uint32_t SIZE = 16;
    const std::array exponents = {64.0f};
    const auto plan =
        PrefilterPlan::make({.exponents = exponents, .lambert = true, .source_size = SIZE});
    ASSERT_TRUE(plan);
    Device device = gpu.device();
    device.on_warning = keep;
    const auto prefilter = Prefilter::create(device);
    ASSERT_TRUE(prefilter);
    std::vector<host::GpuImage> images;
    std::vector<CubeMap> maps;
    for (const PrefilteredMap& map : plan->maps()) {
        images.push_back(make_cube(VK_FORMAT_R16G16B16A16_SFLOAT, map.size,
                                   VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT));
        maps.push_back(cube_of(images.back()));
    }
    const host::GpuBuffer scratch = make_buffer(plan->scratch_size());
    const host::GpuBuffer state = make_buffer(plan->state_size());
    const host::GpuImage whole =
        make_cube(VK_FORMAT_R32G32B32A32_SFLOAT, SIZE, VK_IMAGE_USAGE_SAMPLED_BIT);
    ASSERT_TRUE(prefilter->bind(*plan, cube_of(whole), maps, scratch.handle(), state.handle()));
    EXPECT_TRUE(warnings.empty());
    const host::GpuImage halves =
        make_cube(VK_FORMAT_R16G16B16A16_SFLOAT, SIZE, VK_IMAGE_USAGE_SAMPLED_BIT);
    const auto job =
        prefilter->bind(*plan, cube_of(halves), maps, scratch.handle(), state.handle());
    ASSERT_TRUE(job);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "a source of 16-bit halves cuts suns off at 65504");

    // Two command buffers' worth of passes, behind three queries that are someone else's.
    const std::uint32_t passes = plan->pass_count(), first = 3, queries = first + 2 * passes;
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = queries};
    VkQueryPool pool = VK_NULL_HANDLE;
    ASSERT_EQ(device_function<PFN_vkCreateQueryPool>(gpu, "vkCreateQueryPool")(device.handle, &info,
                                                                               nullptr, &pool),
              VK_SUCCESS);
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        device_function<PFN_vkCmdResetQueryPool>(gpu, "vkCmdResetQueryPool")(commands, pool, 0,
                                                                             queries);
        host::record_layout_change(gpu, commands, halves, VK_IMAGE_LAYOUT_UNDEFINED,
                                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        job->record(commands, 0, 2, {pool, first});
        job->record(commands, 2, passes - 2, {pool, first});
    }));
    std::vector<std::uint64_t> times(2 * passes);
    EXPECT_EQ(device_function<PFN_vkGetQueryPoolResults>(gpu, "vkGetQueryPoolResults")(
                  device.handle, pool, first, 2 * passes, times.size() * 8, times.data(), 8,
                  VK_QUERY_RESULT_64_BIT),
              VK_SUCCESS);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_GT(times.back(), times.front());
    device_function<PFN_vkDestroyQueryPool>(gpu, "vkDestroyQueryPool")(device.handle, pool,
                                                                       nullptr);
}

} // namespace
} // namespace lobelia::test
