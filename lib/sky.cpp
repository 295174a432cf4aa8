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
    .name = "sky",
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

Sky::Sky(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}
Sky::Sky(Sky&&) noexcept = default;
Sky& Sky::operator=(Sky&&) noexcept = default;
Sky::~Sky() = default;

Result<Sky> Sky::create(const Device& device) {
    return vk::guarded([&]() -> Result<Sky> {
        auto context = vk::load(device);
        if (!context) return context.error();
        auto state = std::make_shared<State>();
        state->context = *context;
        auto pass = vk::make_compute_pass(state->context, PASS);
        if (!pass) return pass.error();
        state->pass = std::move(*pass);
        return Sky(std::move(state));
    });
}

Result<SkyJob> Sky::bind(const SkyTarget& target) const {
    return vk::guarded([&]() -> Result<SkyJob> {
        if (!target.image || !target.view || target.width < 2 || target.height < 1)
            return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                         "SkyTarget needs an image and a view of at least 2 x 1 texels"};
        auto sets = vk::make_descriptor_sets(state_->context,
                                             state_->pass.interface.set_layout.get(), BINDINGS, 1);
        if (!sets) return sets.error();
        const vk::Resource resources[] = {vk::storage_image(target.view)};
        vk::write_descriptor_set(state_->context, sets->sets[0], BINDINGS, resources);
        return SkyJob(
            std::unique_ptr<SkyJob::State>(new SkyJob::State{state_, std::move(*sets), target}));
    });
}

SkyJob::SkyJob(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
SkyJob::SkyJob(SkyJob&&) noexcept = default;
SkyJob& SkyJob::operator=(SkyJob&&) noexcept = default;
SkyJob::~SkyJob() = default;

void SkyJob::record(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = state_->shared->context;
    const SkyTarget& target = state_->target;
    const Params params{target.width, target.height};
    vk::image_barrier(context, commands, target.image, vk::DISCARDED, vk::STORED);
    vk::begin_pass(context, commands, state_->shared->pass, state_->sets.sets[0], params);
    context.call.vkCmdDispatch(commands, (target.width + GROUP_SIZE - 1) / GROUP_SIZE,
                               (target.height + GROUP_SIZE - 1) / GROUP_SIZE, 1);
    vk::image_barrier(context, commands, target.image, vk::STORED, vk::SAMPLED);
}

} // namespace lobelia
