#include <lobelia/mips.h>

#include <bit>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "mips.comp.inc"
};
constexpr std::uint32_t HALF_SPIRV[] = {
#include "mips_half.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // source
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,          // target, one level
};

struct Params { // as in mips.glsl
    std::uint32_t size;
    std::uint32_t copy;
    std::uint32_t equal;
};

constexpr vk::ComputePassDescription describe(std::span<const std::uint32_t> spirv) {
    return {.name = "lobelia mips",
            .spirv = spirv,
            .bindings = BINDINGS,
            .push_constant_size = sizeof(Params)};
}

constexpr std::uint32_t GROUP_SIZE = 8; // local_size_x and _y in mips.glsl
constexpr std::uint32_t FACES = 6;

const char* broken_rule(const CubeMap& source, const CubeMap& target) {
    if (!std::has_single_bit(target.size) || source.size != target.size)
        return "mips are made of a cube map whose size is a power of two, into one of that size";
    if (target.levels < 1 || target.levels > std::uint32_t(std::bit_width(target.size)))
        return "mips have 1 to log2(size) + 1 levels";
    if (target.format != VK_FORMAT_R32G32B32A32_SFLOAT &&
        target.format != VK_FORMAT_R16G16B16A16_SFLOAT)
        return "mips have format R32G32B32A32_SFLOAT or R16G16B16A16_SFLOAT";
    return nullptr;
}

} // namespace

struct Mips::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass whole; // into 32 bits
    vk::ComputePass half;  // into 16
};

struct MipsJob::State {
    std::shared_ptr<const Mips::State> shared;
    const vk::ComputePass* pass;
    vk::ImageView source_view;
    std::vector<vk::ImageView> target_views; // by level
    vk::DescriptorSets sets;                 // by level
    CubeMap target;
    MipWeights weights;
};

Result<Mips> Mips::create(const Device& device) {
    return vk::guarded<Mips>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        state->whole = vk::make_compute_pass(state->context, describe(SPIRV));
        state->half = vk::make_compute_pass(state->context, describe(HALF_SPIRV));
        return Mips(std::move(state));
    });
}

Result<MipsJob> Mips::bind(const CubeMap& source, const CubeMap& target, MipWeights weights) const {
    return vk::guarded<MipsJob>([&] {
        vk::refuse(broken_rule(source, target));
        const vk::Context& context = state_->context;
        auto job = std::make_shared<MipsJob::State>();
        job->shared = state_;
        job->pass = target.format == VK_FORMAT_R16G16B16A16_SFLOAT ? &state_->half : &state_->whole;
        job->target = target;
        job->weights = weights;
        job->source_view =
            vk::make_level_view(context, source.image, source.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        job->sets =
            vk::make_descriptor_sets(context, job->pass->interface, BINDINGS, target.levels);
        for (std::uint32_t level = 0; level < target.levels; ++level) {
            auto view = vk::make_level_view(context, target.image, target.format,
                                            VK_IMAGE_VIEW_TYPE_2D_ARRAY, level);
            const VkImageView before =
                level == 0 ? job->source_view.get() : job->target_views.back().get();
            const vk::Resource resources[] = {
                vk::sampled_image(before, state_->sampler.get()),
                vk::storage_image(view.get()),
            };
            vk::write_descriptor_set(context, job->sets.sets[level], BINDINGS, resources);
            job->target_views.push_back(std::move(view));
        }
        return MipsJob(std::move(job));
    });
}

void MipsJob::record(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::Label label(context, commands, "lobelia mips");
    const CubeMap& target = state_->target;
    vk::image_barrier(context, commands, target.image, vk::DISCARDED, vk::STORED, 0, target.levels);
    for (std::uint32_t level = 0; level < target.levels; ++level) {
        const std::uint32_t size = target.size >> level;
        const std::uint32_t groups = (size + GROUP_SIZE - 1) / GROUP_SIZE;
        vk::begin_pass(context, commands, *state_->pass, state_->sets.sets[level],
                       Params{size, level == 0, state_->weights == MipWeights::equal});
        context.call.vkCmdDispatch(commands, groups, groups, FACES);
        vk::image_barrier(context, commands, target.image, vk::STORED, vk::SAMPLED, level, 1);
    }
}

} // namespace lobelia
