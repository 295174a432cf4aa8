#include "prefilter_plan.h"

#include <algorithm>
#include <cmath>

#include <lobelia/lobe.h>

#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr VkDeviceSize TEXEL_BYTES = 8;
constexpr VkDeviceSize STATE_BYTES = 16 + 8 * 32 + 8 * 16; // PrefilterState of lobelia/suns.glsl
constexpr float LARGEST_EXPONENT = 1e6f;
constexpr float LARGEST_LADDER = 4.1e6f; // what taps ask of the sharpest lobe

} // namespace

VkDeviceSize ChainLevel::bytes() const {
    const VkDeviceSize stride = size + 2 * margin;
    return 6 * stride * stride * TEXEL_BYTES;
}

double edge_excess(const ChainLevel& level) {
    // The Euler-Maclaurin formula's first term for a level of samples, which equals that of
    // averages over texels; a wider blur in the face's plane adds to it as its variance.
    const double texel = 2.0 / level.size;
    const double variance = std::max(level.face_variance, texel * texel / 12);
    return 1.5 * variance / texel;
}

std::uint32_t sun_window(std::uint32_t size) {
    const std::uint32_t texels = std::uint32_t(2 * 3 * 0.015 * size / 2) + 3;
    return (texels + 7) / 8 * 8;
}

float exponent_at(const Ladder& ladder, std::uint32_t rung) noexcept {
    return ladder_exponent(ladder.lowest, float(rung));
}

Result<PrefilterPlan> PrefilterPlan::make(const PrefilterRequest& request) {
    return vk::guarded<PrefilterPlan>([&] {
        const std::uint32_t size = request.source_size;
        if (size < 16 || size > 1024 || (size & (size - 1)))
            vk::refuse("the source's faces are a power of two from 16 to 1024");
        const Ladder& ladder = request.ladder;
        if (ladder.rungs == 1 ||
            (ladder.rungs &&
             !(ladder.lowest >= 1 && exponent_at(ladder, ladder.rungs - 1) <= LARGEST_LADDER)))
            vk::refuse("a ladder has at least two rungs, from exponent 1 to 4e6");
        if (request.map_format != VK_FORMAT_R16G16B16A16_SFLOAT &&
            request.map_format != VK_FORMAT_R32G32B32A32_SFLOAT)
            vk::refuse("maps have format R16G16B16A16_SFLOAT or R32G32B32A32_SFLOAT");
        if (request.exponents.empty() && !request.lambert && !ladder.rungs)
            vk::refuse("a prefilter makes at least one map");
        for (const float exponent : request.exponents)
            if (!(exponent >= 0 && exponent <= LARGEST_EXPONENT))
                vk::refuse("an exponent is a number from 0 to 1e6");
        const float kept = request.levels_up_to;
        if (!(kept >= 0 && kept <= LARGEST_LADDER))
            vk::refuse("levels_up_to is a number from 0 to 4e6");
        auto state = std::make_shared<State>();
        plan_passes(request, *state);
        if (kept > 0)
            for (const PrefilteredMap& map : state->maps)
                if (map.exponent > kept) vk::refuse("no map or rung is sharper than levels_up_to");
        return PrefilterPlan(std::move(state));
    });
}

PrefilterPlan::PrefilterPlan(std::shared_ptr<const State> state) noexcept
    : state_(std::move(state)) {}

std::span<const PrefilteredMap> PrefilterPlan::maps() const noexcept {
    return std::span(state_->maps).first(state_->map_count);
}
Ladder PrefilterPlan::ladder() const noexcept {
    return state_->ladder;
}
std::uint32_t PrefilterPlan::ladder_size() const noexcept {
    return state_->ladder.rungs ? state_->maps.back().size : 0;
}
VkDeviceSize PrefilterPlan::scratch_size() const noexcept {
    return state_->scratch_bytes;
}
VkDeviceSize PrefilterPlan::state_size() const noexcept {
    return STATE_BYTES;
}
std::uint32_t PrefilterPlan::pass_count() const noexcept {
    return std::uint32_t(state_->passes.size());
}

std::uint32_t PrefilterPlan::source_size() const noexcept {
    return state_->source_size;
}
std::uint32_t PrefilterPlan::finest_level() const noexcept {
    return state_->levels.front().size;
}
std::uint32_t PrefilterPlan::first_map_pass() const noexcept {
    return state_->first_map_pass;
}
std::uint32_t PrefilterPlan::source_pass_count() const noexcept {
    return state_->source_passes;
}
bool PrefilterPlan::shares_levels(const PrefilterPlan& other) const noexcept {
    return state_->levels_up_to > 0 && state_->levels_up_to == other.state_->levels_up_to &&
           state_->source_size == other.state_->source_size &&
           state_->quality == other.state_->quality;
}

namespace {

std::uint64_t texels(std::uint64_t size) {
    return 6 * size * size;
}

/// What a pass's time is in proportion to: fetches where they are not one an invocation.
double work_of(const PrefilterPlan::State& plan, const PlannedPass& planned,
               std::uint64_t invocations) {
    const double all = double(invocations);
    switch (planned.kind) {
    case PlannedPass::Kind::statistics: return double(texels(plan.source_size));
    case PlannedPass::Kind::suns: return double(plan.tiles_bytes);
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::suns_out: return all * (1 + planned.block * planned.block);
    case PlannedPass::Kind::blur_level:
    case PlannedPass::Kind::blur_map: {
        const double reach = std::acos(1 - planned.kernel.last_chord);
        const double across = reach * plan.levels[planned.source].size + 2; // texels
        return all * across * across;
    }
    case PlannedPass::Kind::expand:
        return all * double(planned.eigenvalues.size() * planned.eigenvalues.size());
    default: return all;
    }
}

PrefilterPass footprint(const PrefilterPlan::State& state, const PlannedPass& planned) {
    constexpr std::uint64_t SOURCE_BYTES = 16; // of a texel
    constexpr std::uint64_t GROUP = 64;        // invocations of a group
    constexpr std::uint64_t PLACES = 4 * 6;    // texels of an invocation of blur.comp
    const auto level = [&](std::uint32_t i) { return state.levels[i].bytes(); };
    const std::uint64_t map_bytes = state.map_format == VK_FORMAT_R16G16B16A16_SFLOAT ? 8 : 16;
    const auto map = [&](std::uint32_t i) { return texels(state.maps[i].size) * map_bytes; };
    const std::uint64_t source = texels(state.source_size);
    const std::uint64_t terms = std::uint64_t(TERMS) * TERM_BYTES;
    const std::uint64_t target =
        planned.target < state.levels.size() ? texels(state.levels[planned.target].size) : 0;
    switch (planned.kind) {
    case PlannedPass::Kind::statistics:
        return {"statistics", source / GROUP, source * SOURCE_BYTES, state.tiles_bytes};
    case PlannedPass::Kind::suns: return {"suns", GROUP, state.tiles_bytes, STATE_BYTES};
    case PlannedPass::Kind::prepare:
        return {"prepare", target, source * SOURCE_BYTES, level(planned.target)};
    case PlannedPass::Kind::suns_out: {
        const std::uint64_t window = sun_window(state.levels[planned.target].size);
        const std::uint64_t most = MOST_SUNS * 6 * window * window;
        return {"suns out", most, most * planned.block * planned.block * SOURCE_BYTES,
                most * TEXEL_BYTES};
    }
    case PlannedPass::Kind::margins: {
        const ChainLevel& filled = state.levels[planned.target];
        const std::uint64_t most = std::uint64_t(4) * 6 * filled.size * filled.margin;
        return {"margins", most, most * TEXEL_BYTES, most * TEXEL_BYTES};
    }
    case PlannedPass::Kind::halve:
        return {"halve", target, level(planned.source), level(planned.target)};
    case PlannedPass::Kind::blur_level:
        return {"blur level", target / PLACES, level(planned.source), level(planned.target)};
    case PlannedPass::Kind::blur_map:
        return {"blur map", texels(state.maps[*planned.map].size) / PLACES, level(planned.source),
                map(*planned.map)};
    case PlannedPass::Kind::project:
        return {"project", state.terms_bytes / terms * 32, level(planned.source),
                state.terms_bytes};
    case PlannedPass::Kind::sum: return {"sum", TERMS, state.terms_bytes, terms};
    case PlannedPass::Kind::expand: break;
    }
    return {"expand", texels(state.maps[*planned.map].size) / 16, terms, map(*planned.map)};
}

} // namespace

PrefilterPass PrefilterPlan::pass(std::uint32_t index) const noexcept {
    const PlannedPass& planned = state_->passes[index];
    PrefilterPass pass = footprint(*state_, planned);
    pass.work = work_of(*state_, planned, pass.invocations);
    return pass;
}

} // namespace lobelia
