#include <lobelia/irradiance.h>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t ROWS_SPIRV[] = {
#include "irradiance_rows.comp.inc"
};
constexpr std::uint32_t SUM_SPIRV[] = {
#include "irradiance_sum.comp.inc"
};

constexpr VkDescriptorType ROWS_BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // source
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // sums
};
constexpr VkDescriptorType SUM_BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, // sums
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, // coefficients
};

struct RowsParams { // as in irradiance_rows.comp
    std::uint32_t size;
    std::uint32_t shift;
};
struct SumParams { // as in irradiance_sum.comp
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t count;
    std::uint32_t last;
};

constexpr vk::ComputePassDescription ROWS = {.name = "lobelia irradiance rows",
                                             .spirv = ROWS_SPIRV,
                                             .bindings = ROWS_BINDINGS,
                                             .push_constant_size = sizeof(RowsParams)};
constexpr vk::ComputePassDescription SUM = {.name = "lobelia irradiance sum",
                                            .spirv = SUM_SPIRV,
                                            .bindings = SUM_BINDINGS,
                                            .push_constant_size = sizeof(SumParams)};

constexpr std::uint32_t GROUP_SIZE = 64; // local_size_x in irradiance_rows.comp
constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t LARGEST_SIZE = 16384;
constexpr std::uint32_t LEAST_PARTS = 128; // a row: the series of constant light ends below 1e-5
constexpr std::uint32_t COEFFICIENTS = 18; // IRRADIANCE_DEGREE_4 in lobelia/irradiance.glsl
static_assert(Irradiance::COEFFICIENTS_SIZE == COEFFICIENTS * 4 * sizeof(float));

bool is_valid(std::uint32_t size) {
    return size >= 1 && size <= LARGEST_SIZE;
}

// Each texel is cut into 2^shift parts a side.
std::uint32_t part_shift(std::uint32_t size) {
    std::uint32_t shift = 0;
    while (size << shift < LEAST_PARTS) ++shift;
    return shift;
}

void wait_for_sums(const vk::Context& context, VkCommandBuffer commands) {
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_READ_BIT);
}

} // namespace

struct Irradiance::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass rows;
    vk::ComputePass sum;
};

struct IrradianceJob::State {
    std::shared_ptr<const Irradiance::State> shared;
    vk::ImageView source_view;
    vk::DescriptorSets rows_set;
    vk::DescriptorSets sum_set;
    std::uint32_t size;
};

// The rows of all faces, and then the faces.
VkDeviceSize Irradiance::scratch_size(const CubeMap& source) noexcept {
    if (!is_valid(source.size)) return 0;
    const VkDeviceSize rows = source.size << part_shift(source.size);
    return FACES * (rows + 1) * COEFFICIENTS_SIZE;
}

Result<Irradiance> Irradiance::create(const Device& device) {
    return vk::guarded<Irradiance>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        state->rows = vk::make_compute_pass(state->context, ROWS);
        state->sum = vk::make_compute_pass(state->context, SUM);
        return Irradiance(std::move(state));
    });
}

Result<IrradianceJob> Irradiance::bind(const CubeMap& source, VkBuffer scratch,
                                       VkBuffer coefficients) const {
    return vk::guarded<IrradianceJob>([&] {
        if (!is_valid(source.size))
            vk::refuse("irradiance is made of a cube map of 1 to 16384 texels");
        const vk::Context& context = state_->context;
        auto view =
            vk::make_level_view(context, source.image, source.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
        const vk::Resource rows[] = {vk::sampled_image(view.get(), state_->sampler.get()),
                                     vk::buffer_range(scratch)};
        const vk::Resource sum[] = {vk::buffer_range(scratch), vk::buffer_range(coefficients)};
        auto rows_set =
            vk::make_descriptor_set(context, state_->rows.interface, ROWS_BINDINGS, rows);
        auto sum_set = vk::make_descriptor_set(context, state_->sum.interface, SUM_BINDINGS, sum);
        return IrradianceJob(std::make_shared<IrradianceJob::State>(IrradianceJob::State{
            state_, std::move(view), std::move(rows_set), std::move(sum_set), source.size}));
    });
}

void IrradianceJob::record(VkCommandBuffer commands) const noexcept {
    const Irradiance::State& shared = *state_->shared;
    const vk::Context& context = shared.context;
    const vk::Label label(context, commands, "lobelia irradiance");
    const std::uint32_t shift = part_shift(state_->size);
    const std::uint32_t size = state_->size << shift;
    // What read the buffers before must have ended.
    vk::memory_barrier(context, commands, vk::ANY_STAGE, VK_ACCESS_SHADER_WRITE_BIT,
                       VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT);
    vk::begin_pass(context, commands, shared.rows, state_->rows_set.sets[0],
                   RowsParams{size, shift});
    context.call.vkCmdDispatch(commands, (size + GROUP_SIZE - 1) / GROUP_SIZE, FACES, 1);
    wait_for_sums(context, commands);

    const std::uint32_t faces = FACES * size * COEFFICIENTS; // where the faces' sums begin
    vk::begin_pass(context, commands, shared.sum, state_->sum_set.sets[0],
                   SumParams{.from = 0, .to = faces, .count = size, .last = 0});
    context.call.vkCmdDispatch(commands, FACES, 1, 1);
    wait_for_sums(context, commands);
    vk::begin_pass(context, commands, shared.sum, state_->sum_set.sets[0],
                   SumParams{.from = faces, .to = 0, .count = FACES, .last = 1});
    context.call.vkCmdDispatch(commands, 1, 1, 1);
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, vk::ANY_STAGE | VK_PIPELINE_STAGE_HOST_BIT,
                       VK_ACCESS_UNIFORM_READ_BIT | VK_ACCESS_SHADER_READ_BIT |
                           VK_ACCESS_HOST_READ_BIT);
}

} // namespace lobelia
