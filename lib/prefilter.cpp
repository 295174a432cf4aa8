#include <lobelia/prefilter.h>

#include <algorithm>
#include <cmath>

#include "prefilter_groups.h"
#include "prefilter_passes.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t FACES = 6;
constexpr VkDeviceSize LADDER_LOWEST_OFFSET = 12; // bytes, in PrefilterState of lobelia/suns.glsl

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
    std::uint32_t pieces(std::uint32_t index) const {
        return groups_of(plan.state(), pass(index)).pieces();
    }
    PrefilterPosition advance(PrefilterPosition from, double milliseconds,
                              std::span<const PassRate> rates) const noexcept;
    void record(VkCommandBuffer commands, PrefilterPosition from, PrefilterPosition to,
                const PassTimestamps& timestamps) const noexcept;
    void record_pass(VkCommandBuffer commands, std::uint32_t index, std::uint32_t first,
                     std::uint32_t count) const noexcept;
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
    const auto map = [&] { return vk::storage_image(maps[planned.map.value_or(0)].get()); };
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
    case PlannedPass::Kind::blur_map: return {texels(), level_buffer(planned.target), map()};
    case PlannedPass::Kind::project: return {texels(), terms};
    case PlannedPass::Kind::sum: return {terms};
    case PlannedPass::Kind::expand: break;
    }
    return {terms, map()};
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

// Pieces [first, first + count) of a pass.
void PrefilterJob::State::record_pass(VkCommandBuffer commands, std::uint32_t index,
                                      std::uint32_t first, std::uint32_t count) const noexcept {
    const vk::Context& context = shared->context;
    const PlannedPass& planned = pass(index);
    const vk::ComputePass& compute = pipeline(planned);
    const vk::Label label(context, commands, compute.name);
    const auto begin_pass = [&](const auto& params) {
        vk::begin_pass(context, commands, compute, sets[index].sets[0], params);
    };
    const PrefilterPlan::State& all = plan.state();
    switch (planned.kind) {
    case PlannedPass::Kind::statistics: begin_pass(StatisticsParams{all.source_size}); break;
    case PlannedPass::Kind::suns:
        begin_pass(SunsParams{all.source_size, all.ladder.rungs ? all.ladder.lowest : 0.0f});
        break;
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::suns_out: {
        const ChainLevel& to = level(planned.target);
        begin_pass(PrepareParams{to.size, to.margin, planned.block});
        break;
    }
    case PlannedPass::Kind::margins: {
        const ChainLevel& to = level(planned.target);
        begin_pass(MarginsParams{to.size, to.margin});
        break;
    }
    case PlannedPass::Kind::halve: {
        const ChainLevel& to = level(planned.target);
        begin_pass(HalveParams{to.size, to.margin, level(planned.source).margin});
        break;
    }
    case PlannedPass::Kind::blur_level:
    case PlannedPass::Kind::blur_map: {
        const bool to_map = planned.kind == PlannedPass::Kind::blur_map;
        const ChainLevel& from = level(planned.source);
        const std::uint32_t size =
            to_map ? all.maps[*planned.map].size : level(planned.target).size;
        const std::uint32_t across = to_map ? all.across(*planned.map) : size;
        begin_pass(BlurParams{from.size, from.margin, size, level(planned.target).margin, across,
                              float(planned.kernel.sharpness), float(planned.kernel.quadratic),
                              float(planned.kernel.last_chord), float(planned.narrowing),
                              float(planned.drift), float(edge_excess(from))});
        break;
    }
    case PlannedPass::Kind::project: {
        const ChainLevel& from = level(planned.source);
        begin_pass(ProjectParams{from.size, from.margin});
        break;
    }
    case PlannedPass::Kind::sum:
        begin_pass(SumParams{std::uint32_t(all.terms_bytes / (TERMS * TERM_BYTES))});
        break;
    case PlannedPass::Kind::expand: {
        const std::uint32_t size = all.maps[*planned.map].size;
        ExpandParams params{size | all.across(*planned.map) << 16,
                            std::uint32_t(planned.eigenvalues.size()) - 1,
                            float(planned.narrowing),
                            {}};
        std::copy(planned.eigenvalues.begin(), planned.eigenvalues.end(),
                  params.eigenvalues.begin());
        begin_pass(params);
        break;
    }
    }
    const vk::Groups groups = groups_of(all, planned);
    vk::dispatch_pieces(context, commands, groups, first, count);
    if (first + count < groups.pieces()) return;
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                       VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                           VK_ACCESS_UNIFORM_READ_BIT);
}

void PrefilterJob::State::record(VkCommandBuffer commands, PrefilterPosition from,
                                 PrefilterPosition to,
                                 const PassTimestamps& timestamps) const noexcept {
    if (from == to) return;
    const vk::Context& context = shared->context;
    const auto stamp = [&](VkPipelineStageFlagBits stage, std::uint32_t query) {
        if (timestamps.pool)
            context.call.vkCmdWriteTimestamp(commands, stage, timestamps.pool,
                                             timestamps.first + query);
    };
    const vk::Label label(context, commands, "lobelia prefilter");
    const bool from_start = from == PrefilterPosition{};
    const bool from_levels = from == PrefilterPosition{plan.first_map_pass(), 0};
    if (from_start || from_levels) begin(commands);
    if (from_levels && plan.state().levels_up_to > 0 && plan.ladder().rungs) tell_ladder(commands);
    for (PrefilterPosition at = from; at.pass < plan.pass_count() && at != to;
         at = {at.pass + 1, 0}) {
        const std::uint32_t end = at.pass == to.pass ? to.piece : pieces(at.pass);
        stamp(VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 2 * at.pass);
        record_pass(commands, at.pass, at.piece, end - at.piece);
        stamp(VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 2 * at.pass + 1);
        if (at.pass == to.pass) break;
    }
    if (to.pass == plan.pass_count()) end(commands);
}

PrefilterPosition PrefilterJob::State::advance(PrefilterPosition from, double milliseconds,
                                               std::span<const PassRate> rates) const noexcept {
    PrefilterPosition at = from;
    while (at.pass < plan.pass_count()) {
        const PrefilterPass next = plan.pass(at.pass);
        const std::uint32_t all = pieces(at.pass), left = all - at.piece;
        const double piece = predicted_milliseconds(rates, next.name, next.work) / all;
        // The nearest number of pieces: what is over in one frame is under in another.
        double fit = piece > 0 ? std::floor(milliseconds / piece + 0.5) : double(left);
        if (at == from) fit = std::max(fit, 1.0);
        if (fit < double(left)) return {at.pass, at.piece + std::uint32_t(std::max(fit, 0.0))};
        milliseconds -= piece * left;
        at = {at.pass + 1, 0};
    }
    return at;
}

void PrefilterJob::record(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                          const PassTimestamps& timestamps) const noexcept {
    state_->record(commands, {first, 0}, {first + count, 0}, timestamps);
}

PrefilterPosition PrefilterJob::record(VkCommandBuffer commands, PrefilterPosition from,
                                       double milliseconds,
                                       std::span<const PassRate> rates) const noexcept {
    const PrefilterPosition to = state_->advance(from, milliseconds, rates);
    state_->record(commands, from, to, {});
    return to;
}

std::uint32_t PrefilterJob::frames(double milliseconds,
                                   std::span<const PassRate> rates) const noexcept {
    std::uint32_t calls = 0;
    for (PrefilterPosition at; at.pass < state_->plan.pass_count(); ++calls)
        at = state_->advance(at, milliseconds, rates);
    return calls;
}

} // namespace lobelia
