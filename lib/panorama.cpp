#include <lobelia/panorama.h>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "panorama.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // panorama
    VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,          // cube, level 0
};

struct Params { // as in panorama.comp
    std::uint32_t width;
    std::uint32_t height;
    std::uint32_t size;
    std::uint32_t columns;
};

constexpr std::uint32_t GROUP_SIZE = 64; // local_size_x in panorama.comp
constexpr std::uint32_t ALONE[] = {1};
constexpr std::uint32_t TOGETHER[] = {GROUP_SIZE};

constexpr vk::ComputePassDescription describe(std::span<const std::uint32_t> team) {
    return {.name = "lobelia panorama to cube",
            .spirv = SPIRV,
            .bindings = BINDINGS,
            .push_constant_size = sizeof(Params),
            .constants = team};
}

constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t LARGEST_SIDE = 32768;

// lavapipe ends an invocation's loops after 65535 iterations without a word.
constexpr std::uint64_t ITERATIONS_PER_INVOCATION = 60000;

// Of the loops over columns and rows, for one cube texel, at most: reached by the texel around a
// pole, which touches every column.
std::uint64_t most_iterations(std::uint64_t columns, std::uint64_t height, std::uint64_t size) {
    return columns * height / (2 * size) + 2 * columns;
}

// Columns narrow enough for the shader's boundaries to be all but straight between meridians.
constexpr std::uint32_t LEAST_COLUMNS = 256;

} // namespace

struct PanoramaToCube::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass alone;    // an invocation a texel
    vk::ComputePass together; // a workgroup a texel
};

struct PanoramaToCubeJob::State {
    std::shared_ptr<const PanoramaToCube::State> shared;
    vk::ImageView source_view;
    vk::ImageView target_view;
    vk::DescriptorSets sets;
    VkImage target;
    Params params;
    bool together;
};

Result<PanoramaToCube> PanoramaToCube::create(const Device& device) {
    return vk::guarded<PanoramaToCube>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        state->alone = vk::make_compute_pass(state->context, describe(ALONE));
        state->together = vk::make_compute_pass(state->context, describe(TOGETHER));
        return PanoramaToCube(std::move(state));
    });
}

Result<PanoramaToCubeJob> PanoramaToCube::bind(const Panorama& source,
                                               const CubeMap& target) const {
    return vk::guarded<PanoramaToCubeJob>([&] {
        if (source.width < 1 || source.height < 1 || source.width > LARGEST_SIDE ||
            source.height > LARGEST_SIDE)
            vk::refuse("a panorama's sides are 1 to 32768 texels");
        if (target.format != VK_FORMAT_R32G32B32A32_SFLOAT || target.size < 1)
            vk::refuse("the cube map to fill has format R32G32B32A32_SFLOAT and a size");
        const std::uint32_t repeat = (LEAST_COLUMNS + source.width - 1) / source.width;
        const Params params{source.width, source.height, target.size, source.width * repeat};
        const std::uint64_t iterations =
            most_iterations(params.columns, params.height, params.size);
        if (iterations > ITERATIONS_PER_INVOCATION * GROUP_SIZE)
            vk::refuse("the cube map's face is too small for so large a panorama");

        const vk::Context& context = state_->context;
        auto source_view =
            vk::make_level_view(context, source.image, source.format, VK_IMAGE_VIEW_TYPE_2D);
        auto target_view =
            vk::make_level_view(context, target.image, target.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        const vk::Resource resources[] = {
            vk::sampled_image(source_view.get(), state_->sampler.get()),
            vk::storage_image(target_view.get()),
        };
        auto sets = vk::make_descriptor_set(context, state_->alone.interface, BINDINGS, resources);
        return PanoramaToCubeJob(std::make_shared<PanoramaToCubeJob::State>(
            PanoramaToCubeJob::State{state_, std::move(source_view), std::move(target_view),
                                     std::move(sets), target.image, params,
                                     iterations > ITERATIONS_PER_INVOCATION}));
    });
}

void PanoramaToCubeJob::record(VkCommandBuffer commands) const noexcept {
    record(commands, 0, rows());
}

std::uint32_t PanoramaToCubeJob::rows() const noexcept {
    return state_->params.size * FACES;
}

void PanoramaToCubeJob::record(VkCommandBuffer commands, std::uint32_t first,
                               std::uint32_t count) const noexcept {
    const vk::Context& context = state_->shared->context;
    const vk::ComputePass& pass =
        state_->together ? state_->shared->together : state_->shared->alone;
    const vk::Label label(context, commands, "lobelia panorama to cube");
    const std::uint32_t size = state_->params.size;
    const std::uint32_t groups = state_->together ? size : (size + GROUP_SIZE - 1) / GROUP_SIZE;
    if (first == 0) vk::image_barrier(context, commands, state_->target, vk::DISCARDED, vk::STORED);
    vk::begin_pass(context, commands, pass, state_->sets.sets[0], state_->params);
    vk::dispatch_pieces(context, commands, {groups, size, FACES}, first, count);
    if (first + count == rows())
        vk::image_barrier(context, commands, state_->target, vk::STORED, vk::SAMPLED);
}

} // namespace lobelia
