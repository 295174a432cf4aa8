#include <lobelia/prefilter.h>

#include <algorithm>

#include "prefilter_passes.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t FACES = 6;
constexpr std::uint32_t GROUP_SIZE = 8;           // local_size_x and _y of all but the next two
constexpr std::uint32_t TILE_SIZE = 8;            // of statistics.comp
constexpr std::uint32_t SUM_GROUP_SIZE = 64;      // of sum.comp
constexpr std::uint32_t EXPAND_TEXELS = 4;        // of an invocation of expand.comp
constexpr std::uint32_t BROAD_GROUP_SIZE = 4;     // of broad.comp; suns.comp is one group
constexpr VkDeviceSize LADDER_LOWEST_OFFSET = 12; // bytes, in PrefilterState of lobelia/suns.glsl

std::uint32_t groups(std::uint32_t size, std::uint32_t group) {
    return (size + group - 1) / group;
}

} // namespace

struct PrefilterJob::State {
    std::shared_ptr<const Prefilter::State> shared;
    PrefilterPlan plan;
    vk::ImageView source;
    std::vector<vk::ImageView> maps;
    std::vector<VkImage> map_images;
    std::vector<vk::BufferView> levels;
    std::vector<vk::DescriptorSets> sets; // one for each pass
    VkBuffer scratch, state;

    const PlannedPass& pass(std::uint32_t index) const { return plan.state().passes[index]; }
    const ChainLevel& level(std::uint32_t index) const { return plan.state().levels[index]; }
    vk::Resource level_buffer(std::uint32_t index) const {
        return vk::buffer_range(scratch, level(index).offset, level(index).bytes());
    }

    void bind(const CubeMap& from, std::span<const CubeMap> to, VkImage ladder);
    const vk::ComputePass& pipeline(const PlannedPass& planned) const {
        return shared->pipeline(planned, plan.state().map_format == VK_FORMAT_R32G32B32A32_SFLOAT);
    }
    std::vector<vk::Resource> resources(const PlannedPass& planned) const;

    void begin(VkCommandBuffer commands) const noexcept;
    void tell_ladder(VkCommandBuffer commands) const noexcept;
    void end(VkCommandBuffer commands) const noexcept;
    void record_pass(VkCommandBuffer commands, std::uint32_t index) const noexcept;
};

Result<PrefilterJob> Prefilter::bind(const PrefilterPlan& plan, const CubeMap& source,
                                     std::span<const CubeMap> maps, VkBuffer scratch,
                                     VkBuffer state, VkImage ladder) const {
    return vk::guarded<PrefilterJob>([&] {
        if (source.size != plan.state().source_size || maps.size() != plan.maps().size())
            vk::refuse("the source and the maps are those of the plan");
        for (std::size_t i = 0; i < maps.size(); ++i)
            if (maps[i].size != plan.maps()[i].size || maps[i].format != plan.state().map_format)
                vk::refuse("a map has the plan's size and format");
        if (source.format == VK_FORMAT_R16G16B16A16_SFLOAT)
            vk::warn(state_->context, "a source of 16-bit halves cuts suns off at 65504");
        if ((ladder != VK_NULL_HANDLE) != (plan.ladder().rungs > 0))
            vk::refuse("a ladder's image is there where the plan has a ladder");
        auto job = std::make_shared<PrefilterJob::State>(
            PrefilterJob::State{state_, plan, {}, {}, {}, {}, {}, scratch, state});
        job->bind(source, maps, ladder);
        return PrefilterJob(std::move(job));
    });
}

void PrefilterJob::State::bind(const CubeMap& from, std::span<const CubeMap> to, VkImage ladder) {
    const vk::Context& context = shared->context;
    source = vk::make_level_view(context, from.image, from.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY);
    for (const CubeMap& map : to) {
        maps.push_back(
            vk::make_level_view(context, map.image, map.format, VK_IMAGE_VIEW_TYPE_2D_ARRAY));
        map_images.push_back(map.image);
    }
    for (std::uint32_t rung = 0; rung < plan.ladder().rungs; ++rung)
        maps.push_back(
            vk::make_layers_view(context, ladder, plan.state().map_format, FACES * rung, FACES));
    if (ladder) map_images.push_back(ladder);
    for (const ChainLevel& level : plan.state().levels) {
        const VkBufferViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO,
                                          .buffer = scratch,
                                          .format = VK_FORMAT_R32G32B32A32_UINT,
                                          .offset = level.offset,
                                          .range = level.bytes()};
        levels.push_back(vk::make<vk::BufferView>(context, context.call.vkCreateBufferView, info,
                                                  "create buffer view"));
    }
    for (const PlannedPass& planned : plan.state().passes)
        sets.push_back(vk::make_descriptor_set(context, pipeline(planned).interface,
                                               prefilter_bindings(planned.kind),
                                               resources(planned)));
}

// A binding that a pass has no use for repeats another of its kind: every binding must be valid.
std::vector<vk::Resource> PrefilterJob::State::resources(const PlannedPass& planned) const {
    const vk::Resource image = vk::sampled_image(source.get(), shared->sampler.get());
    const vk::Resource tiles = vk::buffer_range(scratch, 0, plan.state().tiles_bytes);
    const vk::Resource state_buffer = vk::buffer_range(state);
    const auto map = [&](std::size_t i) {
        const std::size_t last = planned.maps.empty() ? 0 : planned.maps.size() - 1;
        return vk::storage_image(
            maps[planned.maps.empty() ? 0 : planned.maps[std::min(i, last)]].get());
    };
    const vk::Resource terms = vk::buffer_range(
        scratch, plan.state().terms_offset, std::max<VkDeviceSize>(plan.state().terms_bytes, 1));
    const auto texels = [&] { return vk::texel_buffer(levels[planned.source].get()); };
    switch (planned.kind) {
    case PlannedPass::Kind::statistics: return {image, tiles};
    case PlannedPass::Kind::suns: return {image, tiles, state_buffer};
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::suns_out: return {image, state_buffer, level_buffer(planned.target)};
    case PlannedPass::Kind::margins: return {level_buffer(planned.target)};
    case PlannedPass::Kind::halve: return {texels(), level_buffer(planned.target)};
    case PlannedPass::Kind::blur_level:
    case PlannedPass::Kind::blur_map: return {texels(), level_buffer(planned.target), map(0)};
    case PlannedPass::Kind::project: return {texels(), terms};
    case PlannedPass::Kind::sum: return {terms};
    case PlannedPass::Kind::expand: return {terms, map(0)};
    case PlannedPass::Kind::broad: break;
    }
    return {texels(), map(0), map(1), map(2), map(3)};
}

void PrefilterJob::State::begin(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = shared->context;
    vk::memory_barrier(context, commands, vk::ANY_STAGE, VK_ACCESS_SHADER_WRITE_BIT,
                       VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
    for (const VkImage map : map_images)
        vk::image_barrier(context, commands, map, vk::DISCARDED, vk::STORED);
}

// What the state buffer says of a ladder may be from the plan that made the levels.
void PrefilterJob::State::tell_ladder(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = shared->context;
    vk::memory_barrier(context, commands, vk::ANY_STAGE, VK_ACCESS_SHADER_WRITE_BIT,
                       VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT);
    context.call.vkCmdUpdateBuffer(commands, state, LADDER_LOWEST_OFFSET, sizeof(float),
                                   &plan.state().ladder.lowest);
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_WRITE_BIT, vk::ANY_STAGE,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_UNIFORM_READ_BIT);
}

void PrefilterJob::State::end(VkCommandBuffer commands) const noexcept {
    const vk::Context& context = shared->context;
    for (const VkImage map : map_images)
        vk::image_barrier(context, commands, map, vk::STORED, vk::SAMPLED);
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, vk::ANY_STAGE,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_UNIFORM_READ_BIT);
}

void PrefilterJob::State::record_pass(VkCommandBuffer commands,
                                      std::uint32_t index) const noexcept {
    const vk::Context& context = shared->context;
    const PlannedPass& planned = pass(index);
    const vk::ComputePass& compute = pipeline(planned);
    const vk::Label label(context, commands, compute.name);
    const VkDescriptorSet set = sets[index].sets[0];
    const auto dispatch = [&](const auto& params, std::uint32_t across, std::uint32_t layers) {
        vk::begin_pass(context, commands, compute, set, params);
        context.call.vkCmdDispatch(commands, across, across, layers);
    };

    const std::uint32_t source_size = plan.state().source_size;
    switch (planned.kind) {
    case PlannedPass::Kind::statistics:
        dispatch(StatisticsParams{source_size}, groups(source_size / TILE_SIZE, GROUP_SIZE), FACES);
        break;
    case PlannedPass::Kind::suns:
        dispatch(SunsParams{source_size, plan.ladder().rungs ? plan.ladder().lowest : 0.0f}, 1, 1);
        break;
    case PlannedPass::Kind::prepare: {
        const ChainLevel& to = level(planned.target);
        dispatch(PrepareParams{to.size, to.margin, planned.block}, groups(to.size, GROUP_SIZE),
                 FACES);
        break;
    }
    case PlannedPass::Kind::suns_out: {
        const ChainLevel& to = level(planned.target);
        dispatch(PrepareParams{to.size, to.margin, planned.block}, sun_window(to.size) / GROUP_SIZE,
                 FACES * MOST_SUNS);
        break;
    }
    case PlannedPass::Kind::margins: {
        const ChainLevel& to = level(planned.target);
        vk::begin_pass(context, commands, compute, set, MarginsParams{to.size, to.margin});
        context.call.vkCmdDispatch(commands, groups(to.size, GROUP_SIZE),
                                   groups(to.margin, GROUP_SIZE), 4 * FACES);
        break;
    }
    case PlannedPass::Kind::halve: {
        const ChainLevel& to = level(planned.target);
        dispatch(HalveParams{to.size, to.margin, level(planned.source).margin},
                 groups(to.size, GROUP_SIZE), FACES);
        break;
    }
    case PlannedPass::Kind::blur_level:
    case PlannedPass::Kind::blur_map: {
        const bool to_map = planned.kind == PlannedPass::Kind::blur_map;
        const ChainLevel& from = level(planned.source);
        const std::uint32_t size =
            to_map ? plan.state().maps[planned.maps[0]].size : level(planned.target).size;
        const std::uint32_t across = to_map ? plan.state().across(planned.maps[0]) : size;
        dispatch(BlurParams{from.size, from.margin, size, level(planned.target).margin, across,
                            float(planned.kernel.sharpness), float(planned.kernel.quadratic),
                            float(planned.kernel.last_chord), float(planned.narrowing),
                            float(planned.drift), float(edge_excess(from))},
                 groups(size / 2, GROUP_SIZE), 1);
        break;
    }
    case PlannedPass::Kind::project: {
        const ChainLevel& from = level(planned.source);
        const ProjectParams params{from.size, from.margin};
        vk::begin_pass(context, commands, compute, set, params);
        context.call.vkCmdDispatch(commands, FACES * from.size * from.size / CHUNK_TEXELS, 1, 1);
        break;
    }
    case PlannedPass::Kind::sum: {
        const SumParams params{std::uint32_t(plan.state().terms_bytes / (TERMS * TERM_BYTES))};
        vk::begin_pass(context, commands, compute, set, params);
        context.call.vkCmdDispatch(commands, groups(TERMS, SUM_GROUP_SIZE), 1, 1);
        break;
    }
    case PlannedPass::Kind::expand: {
        const std::uint32_t size = plan.state().maps[planned.maps[0]].size;
        ExpandParams params{size | plan.state().across(planned.maps[0]) << 16,
                            std::uint32_t(planned.values.size()) - 1,
                            float(planned.narrowing),
                            {}};
        std::copy(planned.values.begin(), planned.values.end(), params.eigenvalues.begin());
        vk::begin_pass(context, commands, compute, set, params);
        context.call.vkCmdDispatch(
            commands, groups(3 * size * size / 4 / EXPAND_TEXELS, SUM_GROUP_SIZE), 1, 1);
        break;
    }
    case PlannedPass::Kind::broad: {
        const std::uint32_t size = plan.state().maps[planned.maps[0]].size;
        const ChainLevel& from = level(planned.source);
        BroadParams params{{}, from.size, size, float(planned.narrowing), float(edge_excess(from))};
        std::copy(planned.values.begin(), planned.values.end(), params.exponents.begin());
        dispatch(params, groups(size, BROAD_GROUP_SIZE), 1);
        break;
    }
    }
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                           VK_ACCESS_UNIFORM_READ_BIT);
}

void PrefilterJob::record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                          const PassTimestamps& timestamps) const noexcept {
    if (count == 0) return;
    const vk::Context& context = state_->shared->context;
    const auto stamp = [&](VkPipelineStageFlagBits stage, std::uint32_t query) {
        if (timestamps.pool)
            context.call.vkCmdWriteTimestamp(commands, stage, timestamps.pool,
                                             timestamps.first + query);
    };
    const vk::Label label(context, commands, "lobelia prefilter");
    const bool from_levels = first == state_->plan.first_map_pass();
    if (first == 0 || from_levels) state_->begin(commands);
    if (from_levels && state_->plan.state().levels_up_to > 0 && state_->plan.ladder().rungs)
        state_->tell_ladder(commands);
    for (std::uint32_t index = first; index < first + count; ++index) {
        stamp(VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 2 * index);
        state_->record_pass(commands, index);
        stamp(VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 2 * index + 1);
    }
    if (first + count == state_->plan.pass_count()) state_->end(commands);
}

} // namespace lobelia
