#include <lobelia/map_reader.h>

#include <algorithm>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "map_reader.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // map
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,         // state
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // directions
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // results
};

struct Params { // as in map_reader.comp
    float exponent;
    std::uint32_t first;
    std::uint32_t count;
};

constexpr std::uint32_t GROUP_SIZE = 64;     // local_size_x in map_reader.comp
constexpr std::uint32_t MOST_GROUPS = 65535; // that every device dispatches
constexpr std::uint32_t FILTERS[2][1] = {{0}, {1}};

} // namespace

struct MapReader::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass passes[2]; // by MapFilter
};

struct MapReaderJob::State {
    std::shared_ptr<const MapReader::State> shared;
    vk::DescriptorSets sets;
    MapReader::Request request;
};

Result<MapReader> MapReader::create(const Device& device) {
    return vk::guarded<MapReader>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);
        for (int filter = 0; filter < 2; ++filter) {
            state->passes[filter] =
                vk::make_compute_pass(state->context, {"lobelia map reader", SPIRV, BINDINGS,
                                                       sizeof(Params), FILTERS[filter]});
        }
        return MapReader(std::move(state));
    });
}

Result<MapReaderJob> MapReader::bind(const Request& request) const {
    return vk::guarded<MapReaderJob>([&] {
        if (request.count == 0) vk::refuse("the list of directions is empty");
        const vk::Resource resources[] = {
            vk::sampled_image(request.view, state_->sampler.get()),
            vk::buffer_range(request.state),
            vk::buffer_range(request.directions),
            vk::buffer_range(request.results),
        };
        auto sets = vk::make_descriptor_set(state_->context, state_->passes[0].interface, BINDINGS,
                                            resources);
        return MapReaderJob(std::make_shared<MapReaderJob::State>(
            MapReaderJob::State{state_, std::move(sets), request}));
    });
}

void MapReaderJob::record(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::Label label(context, commands, "lobelia map reader");
    const MapReader::Request& request = state_->request;
    const vk::ComputePass& pass = state_->shared->passes[std::size_t(request.map.filter)];
    for (std::uint32_t first = 0; first < request.count; first += MOST_GROUPS * GROUP_SIZE) {
        const std::uint32_t groups = (request.count - first + GROUP_SIZE - 1) / GROUP_SIZE;
        vk::begin_pass(context, commands, pass, state_->sets.sets[0],
                       Params{request.map.exponent, first, request.count});
        context.call.vkCmdDispatch(commands, std::min(groups, MOST_GROUPS), 1, 1);
    }
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, vk::ANY_STAGE | VK_PIPELINE_STAGE_HOST_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_HOST_READ_BIT);
}

} // namespace lobelia
