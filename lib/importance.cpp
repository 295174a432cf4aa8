#include <lobelia/importance.h>

#include <algorithm>
#include <bit>

#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t SPIRV[] = {
#include "importance.comp.inc"
};

constexpr VkDescriptorType BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // source
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // directions
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // results
};

struct Params { // as in importance.comp
    float exponent;
    float size;
    std::uint32_t samples;
    std::uint32_t first_sample;
    std::uint32_t end_sample;
    std::uint32_t first_query;
    std::uint32_t end_query;
};

constexpr std::uint32_t GROUP_SIZE = 64;     // local_size_x in importance.comp
constexpr std::uint32_t MOST_GROUPS = 65535; // that every device dispatches
constexpr std::uint32_t FILTERED[2][1] = {{0}, {1}};

// Samples of one direction that are summed in a row: sums of sums keep their digits, and lavapipe
// ends an invocation's loops after 65535 iterations without a word.
constexpr std::uint32_t BATCH = 256;

constexpr float LARGEST_EXPONENT = 1e6f;
constexpr std::uint32_t MOST_SAMPLES = 65535;

const char* broken_rule(const CubeMap& source, const ImportanceSettings& settings) {
    if (!(settings.exponent >= 0.0f && settings.exponent <= LARGEST_EXPONENT))
        return "exponents are from 0 to 1e6";
    if (settings.samples < 1 || settings.samples > MOST_SAMPLES) return "samples are 1 to 65535";
    if (settings.query_count == 0) return "the list of directions is empty";
    if (source.size == 0) return "a cube map has a size";
    if (settings.filtered && source.levels != std::uint32_t(std::bit_width(source.size)))
        return "filtered importance sampling reads all levels of a cube map, down to 1 texel";
    return nullptr;
}

std::uint32_t parts(std::uint32_t whole, std::uint32_t part) {
    return (whole - 1) / part + 1;
}

} // namespace

struct Importance::State {
    vk::Context context;
    vk::Sampler sampler;
    vk::ComputePass passes[2]; // by `filtered`
};

struct ImportanceJob::State {
    std::shared_ptr<const Importance::State> shared;
    vk::ImageView view;
    vk::DescriptorSets sets;
    ImportanceSettings settings;
    std::uint32_t size; // of the source
    std::uint32_t queries_per_step;

    void record_step(VkCommandBuffer commands, std::uint32_t step) const noexcept;
};

Result<Importance> Importance::create(const Device& device) {
    return vk::guarded<Importance>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);
        for (int filtered = 0; filtered < 2; ++filtered) {
            state->passes[filtered] =
                vk::make_compute_pass(state->context, {"lobelia importance", SPIRV, BINDINGS,
                                                       sizeof(Params), FILTERED[filtered]});
        }
        return Importance(std::move(state));
    });
}

Result<ImportanceJob> Importance::bind(const CubeMap& source, const ImportanceSettings& settings,
                                       VkBuffer directions, VkBuffer results) const {
    return vk::guarded<ImportanceJob>([&] {
        vk::refuse(broken_rule(source, settings));
        const vk::Context& context = state_->context;
        auto view = vk::make_cube_view(context, source.image, source.format, source.levels);
        const vk::Resource resources[] = {
            vk::sampled_image(view.get(), state_->sampler.get()),
            vk::buffer_range(directions),
            vk::buffer_range(results),
        };
        auto sets =
            vk::make_descriptor_set(context, state_->passes[0].interface, BINDINGS, resources);
        const auto queries = std::uint32_t(
            std::clamp<std::uint64_t>(settings.samples_per_step / std::min(settings.samples, BATCH),
                                      1, std::uint64_t(MOST_GROUPS) * GROUP_SIZE));
        return ImportanceJob(std::make_shared<ImportanceJob::State>(ImportanceJob::State{
            state_, std::move(view), std::move(sets), settings, source.size, queries}));
    });
}

std::uint32_t ImportanceJob::steps() const noexcept {
    const ImportanceSettings& settings = state_->settings;
    return parts(settings.query_count, state_->queries_per_step) * parts(settings.samples, BATCH);
}

void ImportanceJob::State::record_step(VkCommandBuffer commands,
                                       std::uint32_t step) const noexcept {
    const std::uint32_t batches = parts(settings.samples, BATCH);
    const std::uint32_t first_sample = step % batches * BATCH;
    const std::uint32_t first_query = step / batches * queries_per_step;
    const std::uint32_t queries = std::min(queries_per_step, settings.query_count - first_query);
    const Params params{.exponent = settings.exponent,
                        .size = float(size),
                        .samples = settings.samples,
                        .first_sample = first_sample,
                        .end_sample = std::min(first_sample + BATCH, settings.samples),
                        .first_query = first_query,
                        .end_query = first_query + queries};
    const vk::Context& context = shared->context;
    vk::begin_pass(context, commands, shared->passes[settings.filtered], sets.sets[0], params);
    context.call.vkCmdDispatch(commands, parts(queries, GROUP_SIZE), 1, 1);
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, vk::ANY_STAGE | VK_PIPELINE_STAGE_HOST_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                           VK_ACCESS_HOST_READ_BIT);
}

void ImportanceJob::record(VkCommandBuffer commands, std::uint32_t first,
                           std::uint32_t count) const noexcept {
    const vk::Label label(state_->shared->context, commands, "lobelia importance");
    for (std::uint32_t step = first; step < first + count; ++step)
        state_->record_step(commands, step);
}

} // namespace lobelia
