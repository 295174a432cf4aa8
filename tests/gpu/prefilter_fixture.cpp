#include "prefilter_fixture.h"

namespace lobelia::test {

namespace {

constexpr std::uint32_t READ_SPIRV[] = {
#include "read_prefiltered.comp.inc"
};

} // namespace

std::vector<host::GpuImage> PrefilterTest::images_for(const PrefilterPlan& plan) {
    std::vector<host::GpuImage> images;
    for (const PrefilteredMap& map : plan.maps())
        images.push_back(value_of(
            gpu.create_image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                              .width = map.size,
                              .height = map.size,
                              .layers = 6,
                              .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                              .cube = true})));
    return images;
}

host::GpuBuffer PrefilterTest::storage(VkDeviceSize bytes, VkBufferUsageFlags more) {
    host::GpuBuffer buffer = value_of(
        gpu.create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | more, host::Memory::host));
    std::memset(buffer.data(), 0xff, bytes); // NaN: nothing leans on what was there
    return buffer;
}

Prefiltered PrefilterTest::make(const host::GpuImage& source, const Wanted& wanted,
                                const std::vector<std::uint32_t>& split) {
    PrefilterPlan plan = plan_for(wanted, source.description().width);
    Prefiltered made{plan, images_for(plan),
                     storage(plan.state_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)};
    std::vector<CubeMap> targets;
    for (const host::GpuImage& map : made.maps) targets.push_back(cube_of(map));
    const host::GpuBuffer scratch =
        storage(plan.scratch_size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const PrefilterJob job = value_of(
        prefilter.bind(plan, cube_of(source), targets, scratch.handle(), made.state.handle()));

    std::uint32_t first = 0;
    const auto submit = [&](std::uint32_t count) {
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands, first, count); }));
        first += count;
    };
    for (std::uint32_t count : split)
        if (count <= plan.pass_count() - first) submit(count);
    submit(plan.pass_count() - first);
    return made;
}

vk::ComputePass PrefilterTest::make_reading(const vk::Context& context) {
    return value_of(vk::make_compute_pass(context, {.name = "read prefiltered",
                                                    .spirv = READ_SPIRV,
                                                    .bindings = READ_BINDINGS,
                                                    .push_constant_size = sizeof(ReadParams)}));
}

std::vector<PrefilterTest::Average> PrefilterTest::read(const Prefiltered& made, std::size_t map,
                                                        const Directions& axes) {
    const host::GpuBuffer directions = storage(axes.size() * sizeof(vec4));
    const host::GpuBuffer averages = storage(axes.size() * sizeof(vec4));
    auto* direction = reinterpret_cast<vec4*>(directions.data());
    for (const oracle::Direction& axis : axes) *direction++ = vec4(axis.x, axis.y, axis.z, 0);

    const vk::DescriptorSets sets = value_of(
        vk::make_descriptor_sets(context_, reading_.interface.set_layout.get(), READ_BINDINGS, 1));
    const vk::Resource resources[] = {vk::sampled_image(made.maps[map].view(), linear_.get()),
                                      vk::buffer_range(made.state.handle()),
                                      vk::buffer_range(directions.handle()),
                                      vk::buffer_range(averages.handle())};
    vk::write_descriptor_set(context_, sets.sets[0], READ_BINDINGS, resources);
    const PrefilteredMap& kind = made.plan.maps()[map];
    const ReadParams params{kind.exponent, kind.filter == MapFilter::spline ? 1u : 0u};
    value_of(gpu.submit([&](VkCommandBuffer commands) {
        vk::begin_pass(context_, commands, reading_, sets.sets[0], params);
        context_.call.vkCmdDispatch(commands, std::uint32_t(axes.size() + 63) / 64, 1, 1);
        vk::memory_barrier(context_, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                           VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                           VK_ACCESS_HOST_READ_BIT);
    }));
    std::vector<Average> values(axes.size());
    std::memcpy(values.data(), averages.data(), axes.size() * sizeof(vec4));
    return values;
}

} // namespace lobelia::test
