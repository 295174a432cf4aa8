#include <lobelia/cube_to_cube.h>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "cube_to_cube.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // source
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,          // target, level 0
};

struct Params { // as in cube_to_cube.comp
    std::uint32_t source_size;
    std::uint32_t size;
};

constexpr std::uint32_t GROUP_SIZE = 64; // local_size_x in cube_to_cube.comp
constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t LARGEST_SIZE = 16384; // of which the shader's products have 32 bits
// lavapipe ends an invocation's loops after 65535 iterations without a word.
constexpr std::uint32_t MOST_SHRINKING = 200;

const char* broken_rule(const CubeMap& source, const CubeMap& target) {
    if (source.size < 1 || source.size > LARGEST_SIZE || target.size < 1 ||
        target.size > LARGEST_SIZE)
        return "a cube map to resample has faces of 1 to 16384 texels a side";
    if (source.size > MOST_SHRINKING * target.size)
        return "the cube map's faces are made more than 200 times smaller, do it in two steps";
    if (target.format != VK_FORMAT_R32G32B32A32_SFLOAT)
        return "the cube map to fill has format R32G32B32A32_SFLOAT";
    return nullptr;
}

} // namespace

struct CubeToCube::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass pass;
};

struct CubeToCubeJob::State {
    std::shared_ptr<const CubeToCube::State> shared;
    vk::ImageView source_view;
    vk::ImageView target_view;
    vk::DescriptorSets sets;
    VkImage target;
    Params params;
};

Result<CubeToCube> CubeToCube::create(const Device& device) {
    return vk::guarded<CubeToCube>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        state->pass = vk::make_compute_pass(state->context, {.name = "lobelia cube to cube",
                                                             .spirv = SPIRV,
                                                             .bindings = BINDINGS,
                                                             .push_constant_size = sizeof(Params)});
        return CubeToCube(std::move(state));
    });
}

Result<CubeToCubeJob> CubeToCube::bind(const CubeMap& source, const CubeMap& target) const {
    return vk::guarded<CubeToCubeJob>([&] {
        vk::refuse(broken_rule(source, target));
        const vk::Context& context = state_->context;
        auto source_view =
            vk::make_level_view(context, source.image, source.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        auto target_view =
            vk::make_level_view(context, target.image, target.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        const vk::Resource resources[] = {
            vk::sampled_image(source_view.get(), state_->sampler.get()),
            vk::storage_image(target_view.get()),
        };
        auto sets = vk::make_descriptor_set(context, state_->pass.interface, BINDINGS, resources);
        return CubeToCubeJob(std::make_shared<CubeToCubeJob::State>(
            CubeToCubeJob::State{state_, std::move(source_view), std::move(target_view),
                                 std::move(sets), target.image, Params{source.size, target.size}}));
    });
}

void CubeToCubeJob::record(VkCommandBuffer commands) const noexcept {
    record(commands, 0, rows());
}

std::uint32_t CubeToCubeJob::rows() const noexcept {
    return state_->params.size * FACES;
}

void CubeToCubeJob::record(VkCommandBuffer commands, std::uint32_t first,
                           std::uint32_t count) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::Label label(context, commands, "lobelia cube to cube");
    const std::uint32_t size = state_->params.size;
    if (first == 0) vk::image_barrier(context, commands, state_->target, vk::DISCARDED, vk::STORED);
    vk::begin_pass(context, commands, state_->shared->pass, state_->sets.sets[0], state_->params);
    vk::dispatch_pieces(context, commands, {(size + GROUP_SIZE - 1) / GROUP_SIZE, size, FACES},
                        first, count);
    if (first + count == rows())
        vk::image_barrier(context, commands, state_->target, vk::STORED, vk::SAMPLED);
}

} // namespace lobelia
