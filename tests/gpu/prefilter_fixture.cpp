#include "prefilter_fixture.h"

namespace lobelia::test {

namespace {

constexpr std::uint32_t READ_SPIRV[] = {
#include "read_prefiltered.comp.inc"
};

} // namespace

vk::ComputePass PrefilterTest::make_reading(const vk::Context& context) {
    return vk::make_compute_pass(context, {.name = "read prefiltered",
                                           .spirv = READ_SPIRV,
                                           .bindings = READ_BINDINGS,
                                           .push_constant_size = sizeof(ReadParams)});
}

std::vector<PrefilterTest::Average> PrefilterTest::read(const Prefiltered& made, std::size_t map,
                                                        const Directions& axes) {
    const host::GpuBuffer directions = storage(axes.size() * sizeof(vec4));
    const host::GpuBuffer averages = storage(axes.size() * sizeof(vec4));
    auto* direction = reinterpret_cast<vec4*>(directions.data());
    for (const oracle::Direction& axis : axes) *direction++ = vec4(axis.x, axis.y, axis.z, 0);

    const vk::DescriptorSets sets =
        vk::make_descriptor_sets(context_, reading_.interface, READ_BINDINGS, 1);
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
