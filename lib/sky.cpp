#include <lobelia/sky.h>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "sky.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, // panorama
};

struct Params { // as in sky.comp
    std::uint32_t width;
    std::uint32_t height;
};

constexpr vk::ComputePassDescription PASS = {
    .name = "lobelia sky",
    .spirv = SPIRV,
    .bindings = BINDINGS,
    .push_constant_size = sizeof(Params),
};

constexpr std::uint32_t GROUP_SIZE = 8; // local_size_x and _y in sky.comp

} // namespace

struct Sky::State {
    vk::Context context;
    vk::ComputePass pass;
};

struct SkyJob::State {
    std::shared_ptr<const Sky::State> shared;
    vk::DescriptorSets sets;
    SkyTarget target;
};

Result<Sky> Sky::create(const Device& device) {
    return vk::guarded<Sky>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->pass = vk::make_compute_pass(state->context, PASS);
        return Sky(std::move(state));
    });
}

Result<SkyJob> Sky::bind(const SkyTarget& target) const {
    return vk::guarded<SkyJob>([&] {
        if (!target.image || !target.view || target.width < 2 || target.height < 1)
            vk::refuse("SkyTarget needs an image and a view of at least 2 x 1 texels");
        const vk::Resource resources[] = {vk::storage_image(target.view)};
        auto sets =
            vk::make_descriptor_set(state_->context, state_->pass.interface, BINDINGS, resources);
        return SkyJob(
            std::make_shared<SkyJob::State>(SkyJob::State{state_, std::move(sets), target}));
    });
}

void SkyJob::record(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::Label label(context, commands, "lobelia sky");
    const SkyTarget& target = state_->target;
    const Params params{target.width, target.height};
    vk::image_barrier(context, commands, target.image, vk::DISCARDED, vk::STORED);
    vk::begin_pass(context, commands, state_->shared->pass, state_->sets.sets[0], params);
    context.call.vkCmdDispatch(commands, (target.width + GROUP_SIZE - 1) / GROUP_SIZE,
                               (target.height + GROUP_SIZE - 1) / GROUP_SIZE, 1);
    vk::image_barrier(context, commands, target.image, vk::STORED, vk::SAMPLED);
}

} // namespace lobelia
