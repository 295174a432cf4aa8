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
constexpr std::uint32_t MARGINS_SPIRV[] = {
#include "margins.comp.inc"
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
constexpr VkDescriptorType UNIFORM = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType MAP = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

constexpr VkDescriptorType STATISTICS_BINDINGS[] = {IMAGE, BUFFER};         // source, tiles
constexpr VkDescriptorType SUNS_BINDINGS[] = {IMAGE, BUFFER, BUFFER};       // source, tiles, state
constexpr VkDescriptorType PREPARE_BINDINGS[] = {IMAGE, UNIFORM, BUFFER};   // source, state, level
constexpr VkDescriptorType MARGINS_BINDINGS[] = {BUFFER};                   // level
constexpr VkDescriptorType HALVE_BINDINGS[] = {TEXELS, BUFFER};             // source, level
constexpr VkDescriptorType BLUR_BINDINGS[] = {TEXELS, BUFFER, MAP};         // source, level, map
constexpr VkDescriptorType PROJECT_BINDINGS[] = {TEXELS, BUFFER};           // source, terms
constexpr VkDescriptorType SUM_BINDINGS[] = {BUFFER};                       // terms
constexpr VkDescriptorType EXPAND_BINDINGS[] = {BUFFER, MAP};               // terms, map
constexpr VkDescriptorType BROAD_BINDINGS[] = {TEXELS, MAP, MAP, MAP, MAP}; // source, maps

/// One kind of pass: its shader and the specialisation constants of each variant.
struct PassKind {
    const char* name;
    std::span<const std::uint32_t> spirv;
    std::span<const VkDescriptorType> bindings;
    std::uint32_t push_constant_size;
    std::vector<std::vector<std::uint32_t>> variants = {{}};
};

PassKind describe(PlannedPass::Kind kind) {
    switch (kind) {
    case PlannedPass::Kind::statistics:
        return {"statistics", STATISTICS_SPIRV, STATISTICS_BINDINGS, sizeof(StatisticsParams)};
    case PlannedPass::Kind::suns:
        return {"suns", SUNS_SPIRV, SUNS_BINDINGS, sizeof(StatisticsParams)};
    case PlannedPass::Kind::prepare: // AT_SUNS, ONE_TEXEL
        return {
            "prepare", PREPARE_SPIRV, PREPARE_BINDINGS, sizeof(PrepareParams), {{0, 0}, {0, 1}}};
    case PlannedPass::Kind::suns_out:
        return {
            "suns out", PREPARE_SPIRV, PREPARE_BINDINGS, sizeof(PrepareParams), {{1, 0}, {1, 1}}};
    case PlannedPass::Kind::margins:
        return {"margins", MARGINS_SPIRV, MARGINS_BINDINGS, sizeof(MarginsParams)};
    case PlannedPass::Kind::halve:
        return {"halve", HALVE_SPIRV, HALVE_BINDINGS, sizeof(HalveParams)};
    case PlannedPass::Kind::blur_level: // TO_IMAGE
        return {"blur level", BLUR_SPIRV, BLUR_BINDINGS, sizeof(BlurParams), {{0}}};
    case PlannedPass::Kind::blur_map:
        return {"blur map", BLUR_SPIRV, BLUR_BINDINGS, sizeof(BlurParams), {{1}}};
    case PlannedPass::Kind::project:
        return {"project", PROJECT_SPIRV, PROJECT_BINDINGS, sizeof(ProjectParams)};
    case PlannedPass::Kind::sum: return {"sum", SUM_SPIRV, SUM_BINDINGS, sizeof(SumParams)};
    case PlannedPass::Kind::expand:
        return {"expand", EXPAND_SPIRV, EXPAND_BINDINGS, sizeof(ExpandParams)};
    case PlannedPass::Kind::broad: break;
    }
    PassKind broad{"broad", BROAD_SPIRV, BROAD_BINDINGS, sizeof(BroadParams), {}};
    for (std::uint32_t maps = 1; maps <= BROAD_MAPS; ++maps) broad.variants.push_back({maps});
    return broad;
}

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

        for (std::size_t kind = 0; kind < PASS_KINDS; ++kind) {
            const PassKind made = describe(PlannedPass::Kind(kind));
            for (const std::vector<std::uint32_t>& constants : made.variants) {
                auto pass =
                    vk::make_compute_pass(state->context, {made.name, made.spirv, made.bindings,
                                                           made.push_constant_size, constants});
                if (!pass) return pass.error();
                state->passes[kind].push_back(std::move(*pass));
            }
        }
        return Prefilter(std::move(state));
    });
}

std::size_t variant_of(const PlannedPass& planned) {
    switch (planned.kind) {
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::suns_out: return planned.block == 1 ? 1 : 0;
    case PlannedPass::Kind::broad: return planned.maps.size() - 1;
    default: return 0;
    }
}

std::span<const VkDescriptorType> prefilter_bindings(PlannedPass::Kind kind) {
    return describe(kind).bindings;
}

} // namespace lobelia
