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
constexpr std::uint32_t BLUR_FLOAT_SPIRV[] = {
#include "blur_float.comp.inc"
};
constexpr std::uint32_t EXPAND_FLOAT_SPIRV[] = {
#include "expand_float.comp.inc"
};

constexpr VkDescriptorType IMAGE = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType BUFFER = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType TEXELS = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
constexpr VkDescriptorType UNIFORM = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType MAP = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

constexpr VkDescriptorType STATISTICS_BINDINGS[] = {IMAGE, BUFFER};       // source, tiles
constexpr VkDescriptorType SUNS_BINDINGS[] = {IMAGE, BUFFER, BUFFER};     // source, tiles, state
constexpr VkDescriptorType PREPARE_BINDINGS[] = {IMAGE, UNIFORM, BUFFER}; // source, state, level
constexpr VkDescriptorType MARGINS_BINDINGS[] = {BUFFER};                 // level
constexpr VkDescriptorType HALVE_BINDINGS[] = {TEXELS, BUFFER};           // source, level
constexpr VkDescriptorType BLUR_BINDINGS[] = {TEXELS, BUFFER, MAP};       // source, level, map
constexpr VkDescriptorType PROJECT_BINDINGS[] = {TEXELS, BUFFER};         // source, terms
constexpr VkDescriptorType SUM_BINDINGS[] = {BUFFER};                     // terms
constexpr VkDescriptorType EXPAND_BINDINGS[] = {BUFFER, MAP};             // terms, map

/// A pipeline of a kind of pass.
struct Variant {
    std::span<const std::uint32_t> spirv;
    std::vector<std::uint32_t> constants = {};
};

struct PassKind {
    const char* name;
    std::span<const VkDescriptorType> bindings;
    std::uint32_t push_constant_size;
    std::vector<Variant> variants; // by variant_of()
};

PassKind describe(PlannedPass::Kind kind) {
    using Kind = PlannedPass::Kind;
    switch (kind) {
    case Kind::statistics:
        return {"lobelia statistics",
                STATISTICS_BINDINGS,
                sizeof(StatisticsParams),
                {{STATISTICS_SPIRV}}};
    case Kind::suns: return {"lobelia suns", SUNS_BINDINGS, sizeof(SunsParams), {{SUNS_SPIRV}}};
    case Kind::prepare: // AT_SUNS, ONE_TEXEL
        return {"lobelia prepare",
                PREPARE_BINDINGS,
                sizeof(PrepareParams),
                {{PREPARE_SPIRV, {0, 0}}, {PREPARE_SPIRV, {0, 1}}}};
    case Kind::suns_out:
        return {"lobelia suns out",
                PREPARE_BINDINGS,
                sizeof(PrepareParams),
                {{PREPARE_SPIRV, {1, 0}}, {PREPARE_SPIRV, {1, 1}}}};
    case Kind::margins:
        return {"lobelia margins", MARGINS_BINDINGS, sizeof(MarginsParams), {{MARGINS_SPIRV}}};
    case Kind::halve:
        return {"lobelia halve", HALVE_BINDINGS, sizeof(HalveParams), {{HALVE_SPIRV}}};
    case Kind::blur_level: // TO_IMAGE
        return {"lobelia blur level", BLUR_BINDINGS, sizeof(BlurParams), {{BLUR_SPIRV, {0}}}};
    case Kind::blur_map:
        return {"lobelia blur map",
                BLUR_BINDINGS,
                sizeof(BlurParams),
                {{BLUR_SPIRV, {1}}, {BLUR_FLOAT_SPIRV, {1}}}};
    case Kind::project:
        return {"lobelia project", PROJECT_BINDINGS, sizeof(ProjectParams), {{PROJECT_SPIRV}}};
    case Kind::sum: return {"lobelia sum", SUM_BINDINGS, sizeof(SumParams), {{SUM_SPIRV}}};
    case Kind::expand: break;
    }
    return {"lobelia expand",
            EXPAND_BINDINGS,
            sizeof(ExpandParams),
            {{EXPAND_SPIRV}, {EXPAND_FLOAT_SPIRV}}};
}

} // namespace

Result<Prefilter> Prefilter::create(const Device& device) {
    return vk::guarded<Prefilter>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_NEAREST);

        for (std::size_t kind = 0; kind < PASS_KINDS; ++kind) {
            const PassKind made = describe(PlannedPass::Kind(kind));
            for (const Variant& variant : made.variants) {
                state->passes[kind].push_back(vk::make_compute_pass(
                    state->context, {made.name, variant.spirv, made.bindings,
                                     made.push_constant_size, variant.constants}));
            }
        }
        return Prefilter(std::move(state));
    });
}

std::size_t variant_of(const PlannedPass& planned, bool float_maps) {
    switch (planned.kind) {
    case PlannedPass::Kind::prepare:
    case PlannedPass::Kind::suns_out: return planned.block == 1 ? 1 : 0;
    case PlannedPass::Kind::blur_map:
    case PlannedPass::Kind::expand: return float_maps ? 1 : 0;
    default: return 0;
    }
}

std::span<const VkDescriptorType> prefilter_bindings(PlannedPass::Kind kind) {
    return describe(kind).bindings;
}

} // namespace lobelia
