#include <lobelia/plain_map.h>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "plain_map.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // map
    VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,         // state
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,          // target
};

struct Params { // as in plain_map.comp
    float exponent;
    std::uint32_t size;
};

constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t GROUP_SIZE = 8; // local_size_x and _y in plain_map.comp
constexpr std::uint32_t FILTERS[2][1] = {{0}, {1}};

} // namespace

struct PlainMap::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass passes[2]; // by MapFilter
};

struct PlainMapJob::State {
    std::shared_ptr<const PlainMap::State> shared;
    vk::ImageView target;
    vk::DescriptorSets sets;
    PlainMap::Request request;
};

Result<PlainMap> PlainMap::create(const Device& device) {
    return vk::guarded<PlainMap>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);
        for (int filter = 0; filter < 2; ++filter)
            state->passes[filter] =
                vk::make_compute_pass(state->context, {"lobelia plain map", SPIRV, BINDINGS,
                                                       sizeof(Params), FILTERS[filter]});
        return PlainMap(std::move(state));
    });
}

Result<PlainMapJob> PlainMap::bind(const Request& request) const {
    return vk::guarded<PlainMapJob>([&] {
        const CubeMap& target = request.target;
        if (!request.view || !request.state)
            vk::refuse("a plain map is made of a map's view and its state buffer");
        if (target.format != VK_FORMAT_R32G32B32A32_SFLOAT || target.size < 1)
            vk::refuse("the cube map to fill has format R32G32B32A32_SFLOAT and a size");
        const vk::Context& context = state_->context;
        auto view =
            vk::make_level_view(context, target.image, target.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        const vk::Resource resources[] = {
            vk::sampled_image(request.view, state_->sampler.get()),
            vk::buffer_range(request.state),
            vk::storage_image(view.get()),
        };
        auto sets =
            vk::make_descriptor_set(context, state_->passes[0].interface, BINDINGS, resources);
        return PlainMapJob(std::make_shared<PlainMapJob::State>(
            PlainMapJob::State{state_, std::move(view), std::move(sets), request}));
    });
}

void PlainMapJob::record(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::Label label(context, commands, "lobelia plain map");
    const PlainMap::Request& request = state_->request;
    const vk::ComputePass& pass = state_->shared->passes[std::size_t(request.map.filter)];
    const std::uint32_t size = request.target.size;
    const std::uint32_t groups = (size + GROUP_SIZE - 1) / GROUP_SIZE;
    vk::image_barrier(context, commands, request.target.image, vk::DISCARDED, vk::STORED);
    vk::begin_pass(context, commands, pass, state_->sets.sets[0],
                   Params{request.map.exponent, size});
    context.call.vkCmdDispatch(commands, groups, groups, FACES);
    vk::image_barrier(context, commands, request.target.image, vk::STORED, vk::SAMPLED);
}

} // namespace lobelia
