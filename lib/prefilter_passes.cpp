#include "prefilter_passes.h"

#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t STATISTICS_SPIRV[] = {
#include "statistics.comp.inc"
};
constexpr std::uint32_t SUNS_SPIRV[] = {
#include "suns.comp.inc"
};
constexpr std::uint32_t PREPARE_SPIRV[] = {
#include "prepare.comp.inc"
};
constexpr std::uint32_t HALVE_SPIRV[] = {
#include "halve.comp.inc"
};
constexpr std::uint32_t BLUR_SPIRV[] = {
#include "blur.comp.inc"
};
constexpr std::uint32_t PROJECT_SPIRV[] = {
#include "project.comp.inc"
};
constexpr std::uint32_t SUM_SPIRV[] = {
#include "sum.comp.inc"
};
constexpr std::uint32_t EXPAND_SPIRV[] = {
#include "expand.comp.inc"
};
constexpr std::uint32_t BROAD_SPIRV[] = {
#include "broad.comp.inc"
};

constexpr VkDescriptorType IMAGE = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType BUFFER = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType TEXELS = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
constexpr VkDescriptorType MAP = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

constexpr VkDescriptorType STATISTICS_BINDINGS[] = {IMAGE, BUFFER, BUFFER}; // source, tiles, state
constexpr VkDescriptorType PREPARE_BINDINGS[] = {IMAGE, BUFFER, BUFFER};    // source, state, level
constexpr VkDescriptorType HALVE_BINDINGS[] = {TEXELS, BUFFER};             // source, level
constexpr VkDescriptorType BLUR_BINDINGS[] = {TEXELS, BUFFER, MAP};         // source, level, map
constexpr VkDescriptorType PROJECT_BINDINGS[] = {TEXELS, BUFFER};           // source, terms
constexpr VkDescriptorType SUM_BINDINGS[] = {BUFFER};                       // terms
constexpr VkDescriptorType EXPAND_BINDINGS[] = {BUFFER, MAP};               // terms, map
constexpr VkDescriptorType BROAD_BINDINGS[] = {TEXELS, MAP, MAP, MAP, MAP}; // source, maps

constexpr std::uint32_t TO_LEVEL[] = {0};
constexpr std::uint32_t TO_MAP[] = {1};
constexpr std::uint32_t MAP_COUNTS[BROAD_MAPS][1] = {{1}, {2}, {3}, {4}};

} // namespace

Prefilter::Prefilter(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}
Prefilter::Prefilter(Prefilter&&) noexcept = default;
Prefilter& Prefilter::operator=(Prefilter&&) noexcept = default;
Prefilter::~Prefilter() = default;

Result<Prefilter> Prefilter::create(const Device& device) {
    return vk::guarded([&]() -> Result<Prefilter> {
        auto context = vk::load(device);
        if (!context) return context.error();
        auto state = std::make_shared<State>();
        state->context = *context;
        auto sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);
        if (!sampler) return sampler.error();
        state->sampler = std::move(*sampler);

        struct Made {
            vk::ComputePass State::*pass;
            vk::ComputePassDescription description;
        };
        const Made all[] = {
            {&State::statistics,
             {"statistics", STATISTICS_SPIRV, STATISTICS_BINDINGS, sizeof(StatisticsParams)}},
            {&State::suns, {"suns", SUNS_SPIRV, STATISTICS_BINDINGS, sizeof(StatisticsParams)}},
            {&State::prepare, {"prepare", PREPARE_SPIRV, PREPARE_BINDINGS, sizeof(PrepareParams)}},
            {&State::halve, {"halve", HALVE_SPIRV, HALVE_BINDINGS, sizeof(HalveParams)}},
            {&State::blur_level,
             {"blur level", BLUR_SPIRV, BLUR_BINDINGS, sizeof(BlurParams), TO_LEVEL}},
            {&State::blur_map, {"blur map", BLUR_SPIRV, BLUR_BINDINGS, sizeof(BlurParams), TO_MAP}},
            {&State::project, {"project", PROJECT_SPIRV, PROJECT_BINDINGS, sizeof(ProjectParams)}},
            {&State::sum, {"sum", SUM_SPIRV, SUM_BINDINGS, sizeof(SumParams)}},
            {&State::expand, {"expand", EXPAND_SPIRV, EXPAND_BINDINGS, sizeof(ExpandParams)}},
        };
        for (const Made& made : all) {
            auto pass = vk::make_compute_pass(state->context, made.description);
            if (!pass) return pass.error();
            state.get()->*made.pass = std::move(*pass);
        }
        for (std::uint32_t i = 0; i < BROAD_MAPS; ++i) {
            auto pass = vk::make_compute_pass(state->context, {"broad", BROAD_SPIRV, BROAD_BINDINGS,
                                                               sizeof(BroadParams), MAP_COUNTS[i]});
            if (!pass) return pass.error();
            state->broad[i] = std::move(*pass);
        }
        return Prefilter(std::move(state));
    });
}

const vk::ComputePass& Prefilter::State::pipeline(const PlannedPass& planned) const {
    switch (planned.kind) {
    case PlannedPass::Kind::statistics: return statistics;
    case PlannedPass::Kind::suns: return suns;
    case PlannedPass::Kind::prepare: return prepare;
    case PlannedPass::Kind::halve: return halve;
    case PlannedPass::Kind::blur_level: return blur_level;
    case PlannedPass::Kind::blur_map: return blur_map;
    case PlannedPass::Kind::project: return project;
    case PlannedPass::Kind::sum: return sum;
    case PlannedPass::Kind::expand: return expand;
    case PlannedPass::Kind::broad: break;
    }
    return broad[planned.maps.size() - 1];
}

std::span<const VkDescriptorType> prefilter_bindings(PlannedPass::Kind kind) {
    switch (kind) {
    case PlannedPass::Kind::statistics:
    case PlannedPass::Kind::suns: return STATISTICS_BINDINGS;
    case PlannedPass::Kind::prepare: return PREPARE_BINDINGS;
    case PlannedPass::Kind::halve: return HALVE_BINDINGS;
    case PlannedPass::Kind::blur_level:
    case PlannedPass::Kind::blur_map: return BLUR_BINDINGS;
    case PlannedPass::Kind::project: return PROJECT_BINDINGS;
    case PlannedPass::Kind::sum: return SUM_BINDINGS;
    case PlannedPass::Kind::expand: return EXPAND_BINDINGS;
    case PlannedPass::Kind::broad: break;
    }
    return BROAD_BINDINGS;
}

} // namespace lobelia
