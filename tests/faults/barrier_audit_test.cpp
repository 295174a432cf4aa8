#include <gtest/gtest.h>

#include <lobelia/clipped_tables.h>
#include <lobelia/cube_to_cube.h>
#include <lobelia/exact.h>
#include <lobelia/host/work.h>
#include <lobelia/importance.h>
#include <lobelia/irradiance.h>
#include <lobelia/map_reader.h>
#include <lobelia/mips.h>
#include <lobelia/panorama.h>
#include <lobelia/plain_map.h>
#include <lobelia/prefilter.h>
#include <lobelia/sky.h>

#include "support/gpu_sources.h"
#include "vulkan_shim.h"
#include "workloads.h"

// Whatever the library records, nothing reads or writes what another command writes without a
// barrier between: validation does not look between dispatches, and a CPU device runs in order.
namespace lobelia::test {
namespace {

class BarrierAuditTest : public testing::Test {
protected:
    VulkanShim& shim = VulkanShim::get();
    host::Gpu gpu = value_of(host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()}));

    void SetUp() override { shim.dry = true; } // what is recorded is looked at, not run
    void TearDown() override {
        shim.dry = false;
        for (const std::string& hazard : shim.audit.history.hazards) ADD_FAILURE() << hazard;
    }

    host::GpuImage cube(std::uint32_t size, VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT,
                        std::uint32_t levels = 1) {
        return image({.format = format,
                      .width = size,
                      .height = size,
                      .layers = 6,
                      .levels = levels,
                      .cube = true});
    }
    host::GpuImage image(host::GpuImageDescription shape) {
        shape.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                      VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        return value_of(gpu.create_image(shape));
    }
    host::GpuBuffer buffer(VkDeviceSize bytes) {
        return value_of(gpu.create_buffer(
            bytes,
            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                VK_BUFFER_USAGE_TRANSFER_DST_BIT,
            host::Memory::device));
    }
};

class PrefilterAudit : public BarrierAuditTest,
                       public testing::WithParamInterface<std::tuple<Quality, bool>> {};

// Panorama, cube, maps and what reads them, as an engine may record it: in one command buffer,
// twice over the same objects.
TEST_P(PrefilterAudit, FromThePanoramaToTheReadMap) {
    const auto [quality, with_ladder] = GetParam();
    constexpr std::uint32_t SIZE = 64;
    const host::GpuImage panorama = image({.width = 256, .height = 128});
    const host::GpuImage source = cube(SIZE, VK_FORMAT_R32G32B32A32_SFLOAT);
    const std::array exponents = {0.0f, 1.0f, 8.0f, 64.0f, 700.0f, 1e5f};
    const auto plan =
        value_of(PrefilterPlan::make({.exponents = exponents,
                                      .lambert = true,
                                      .ladder = with_ladder ? Ladder{4.0f, 8} : Ladder{},
                                      .quality = quality,
                                      .source_size = SIZE}));
    std::vector<host::GpuImage> images;
    std::vector<CubeMap> maps;
    for (const PrefilteredMap& map : plan.maps()) {
        images.push_back(cube(map.size));
        maps.push_back(cube_of(images.back()));
    }
    std::optional<host::GpuImage> ladder;
    if (with_ladder)
        ladder = image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                        .width = plan.ladder_size(),
                        .height = plan.ladder_size(),
                        .layers = 6 * plan.ladder().rungs});
    const host::GpuBuffer scratch = buffer(plan.scratch_size()), state = buffer(plan.state_size());
    const host::GpuBuffer directions = buffer(64 * 16), results = buffer(64 * 16);
    const auto sky = value_of(Sky::create(gpu.device()));
    const auto resampling = value_of(PanoramaToCube::create(gpu.device()));
    const auto prefilter = value_of(Prefilter::create(gpu.device()));
    const auto reader = value_of(MapReader::create(gpu.device()));
    const auto plain = value_of(PlainMap::create(gpu.device()));
    const host::GpuImage background = cube(32, VK_FORMAT_R32G32B32A32_SFLOAT);
    const auto painted = value_of(sky.bind({panorama.handle(), panorama.view(), 256, 128}));
    const auto resampled = value_of(resampling.bind(panorama_of(panorama), cube_of(source)));
    const auto filtered =
        value_of(prefilter.bind(plan, cube_of(source), maps, scratch.handle(), state.handle(),
                                ladder ? ladder->handle() : VK_NULL_HANDLE));
    const auto read =
        value_of(reader.bind({plan.maps().front(), images.front().view(), state.handle(),
                              directions.handle(), results.handle(), 64}));
    const auto shown = value_of(plain.bind(
        {plan.maps().front(), images.front().view(), state.handle(), cube_of(background)}));
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        for (int i = 0; i < 2; ++i) {
            painted.record(commands);
            resampled.record(commands);
            filtered.record(commands, 0, plan.pass_count());
            read.record(commands);
            shown.record(commands);
        }
    }));
}

INSTANTIATE_TEST_SUITE_P(Every, PrefilterAudit,
                         testing::Combine(testing::Values(Quality::fast, Quality::normal,
                                                          Quality::high),
                                          testing::Bool()));

TEST_F(BarrierAuditTest, HearsABarrierThatIsMissing) {
    const auto update = reinterpret_cast<PFN_vkCmdUpdateBuffer>(
        gpu.device().get_device_proc_addr(gpu.device().handle, "vkCmdUpdateBuffer"));
    const host::GpuBuffer target = buffer(4);
    const std::uint32_t value = 0;
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        for (int i = 0; i < 2; ++i) update(commands, target.handle(), 0, sizeof value, &value);
    }));
    EXPECT_EQ(shim.audit.history.hazards.size(), 1u);
    shim.audit.history.hazards.clear();
}

TEST_F(BarrierAuditTest, Exact) {
    const host::GpuImage panorama = image({.width = 64, .height = 32});
    const host::GpuImage source = cube(16, VK_FORMAT_R32G32B32A32_SFLOAT);
    const auto exact = value_of(Exact::create(gpu.device()));
    for (const bool clipped : {false, true}) {
        const ExactSettings settings{
            .exponent = 16.0f, .clipped = clipped, .query_count = 100, .nodes_per_step = 1 << 14};
        const auto sizes = value_of(Exact::sizes(panorama_of(panorama), settings));
        const auto cube_sizes = value_of(Exact::sizes(cube_of(source), settings));
        const host::GpuBuffer queries = buffer(sizes.queries), results = buffer(sizes.results),
                              tables = buffer(std::max(sizes.tables, cube_sizes.tables));
        const auto of_panorama = value_of(exact.bind(
            panorama_of(panorama), settings, queries.handle(), results.handle(), tables.handle()));
        const auto of_cube = value_of(exact.bind(cube_of(source), settings, queries.handle(),
                                                 results.handle(), tables.handle()));
        value_of(gpu.submit([&](VkCommandBuffer commands) {
            of_panorama.record(commands, 0, of_panorama.steps());
            of_cube.record(commands, 0, of_cube.steps());
        }));
    }
}

TEST_F(BarrierAuditTest, SizesMipsIrradianceSamplesAndTables) {
    const host::GpuImage odd = cube(48, VK_FORMAT_R32G32B32A32_SFLOAT);
    const host::GpuImage source = cube(64, VK_FORMAT_R32G32B32A32_SFLOAT);
    const host::GpuImage levels = cube(64, VK_FORMAT_R16G16B16A16_SFLOAT, 7);
    const host::GpuImage table = image({.format = ClippedTables::FORMAT,
                                        .width = ClippedTables::WIDTH,
                                        .height = ClippedTables::HEIGHT,
                                        .layers = ClippedTables::LAYERS});
    const host::GpuBuffer scratch = buffer(Irradiance::scratch_size(cube_of(source)));
    const host::GpuBuffer coefficients = buffer(Irradiance::COEFFICIENTS_SIZE);
    const host::GpuBuffer directions = buffer(1000 * 16), results = buffer(1000 * 16);
    const host::GpuBuffer table_buffer = buffer(ClippedTables::BUFFER_BYTES);
    const auto resizing = value_of(CubeToCube::create(gpu.device()));
    const auto mips = value_of(Mips::create(gpu.device()));
    const auto irradiance = value_of(Irradiance::create(gpu.device()));
    const auto importance = value_of(Importance::create(gpu.device()));
    const auto tables = value_of(ClippedTables::create(gpu.device()));
    const auto resized = value_of(resizing.bind(cube_of(odd), cube_of(source)));
    const auto halved = value_of(mips.bind(cube_of(source), cube_of(levels)));
    const auto summed =
        value_of(irradiance.bind(cube_of(source), scratch.handle(), coefficients.handle()));
    const auto sampled = value_of(importance.bind(
        cube_of(levels),
        {.exponent = 8.0f, .samples = 64, .query_count = 1000, .samples_per_step = 1 << 12},
        directions.handle(), results.handle()));
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        for (int i = 0; i < 2; ++i) {
            resized.record(commands);
            halved.record(commands);
            summed.record(commands);
            sampled.record(commands, 0, sampled.steps());
            tables.record(commands, table_buffer.handle(), table.handle());
        }
    }));
}

// What the host does, the sphere by every method among it, with the device's own waits between.
TEST_F(BarrierAuditTest, EveryWorkload) {
    shim.dry = false;
    for (const WorkloadGroup& group : workload_groups())
        for (const Workload& work : group.workloads) value_of(work.run(gpu));
    shim.dry = true;
    const auto light = value_of(host::upload_environment(gpu, even_panorama(64, 32, 1, 1, 1)));
    for (const host::RenderMethod& method : host::render_methods()) {
        SCOPED_TRACE(method.name);
        const SphereView view{
            .material = {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 50.0f}, .width = 4, .height = 4};
        value_of(host::render(gpu, light, {.view = view, .method = method.method}));
    }
}

} // namespace
} // namespace lobelia::test
