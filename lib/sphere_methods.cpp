#include "sphere_methods.h"

namespace lobelia {

namespace {

constexpr std::uint32_t HARMONICS_SPIRV[] = {
#include "sphere_harmonics.frag.inc"
};
constexpr std::uint32_t IMPORTANCE_SPIRV[] = {
#include "sphere_importance.frag.inc"
};
constexpr std::uint32_t KURT2019_SPIRV[] = {
#include "sphere_kurt2019.frag.inc"
};
constexpr std::uint32_t PLAIN_SPIRV[] = {
#include "sphere_plain.frag.inc"
};
constexpr std::uint32_t PREFILTERED_SPIRV[] = {
#include "sphere_prefiltered.frag.inc"
};
constexpr std::uint32_t TAPS_SPIRV[] = {
#include "sphere_taps.frag.inc"
};
constexpr std::uint32_t REFERENCE_SPIRV[] = {
#include "sphere_reference.frag.inc"
};

using Sources = SphereSources;

constexpr SphereBinding map(VkImageView Sources::*view, bool diffuse, bool specular) {
    return {.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
            .view = view,
            .diffuse = diffuse,
            .specular = specular};
}
constexpr SphereBinding storage(VkBuffer Sources::*buffer, bool diffuse, bool specular) {
    return {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
            .buffer = buffer,
            .diffuse = diffuse,
            .specular = specular};
}
constexpr SphereBinding uniform(VkBuffer Sources::*buffer, bool diffuse, bool specular) {
    return {.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
            .buffer = buffer,
            .diffuse = diffuse,
            .specular = specular};
}

constexpr SphereBinding BACKGROUND = map(&Sources::background, true, true);
constexpr SphereBinding DIFFUSE_MAP = map(&Sources::diffuse, true, false);
constexpr SphereBinding SPECULAR_MAP = map(&Sources::specular, false, true);

constexpr SphereBinding STATE = uniform(&Sources::prefilter_state, true, true);

constexpr SphereBinding HARMONICS[] = {BACKGROUND, SPECULAR_MAP,
                                       uniform(&Sources::prefilter_state, false, true),
                                       uniform(&Sources::irradiance, true, false)};
constexpr SphereBinding IMPORTANCE[] = {BACKGROUND, map(&Sources::mips, true, true)};
constexpr SphereBinding KURT2019[] = {BACKGROUND, map(&Sources::blurred, true, true)};
constexpr SphereBinding PLAIN[] = {BACKGROUND, DIFFUSE_MAP, SPECULAR_MAP};
constexpr SphereBinding PREFILTERED[] = {BACKGROUND, DIFFUSE_MAP, SPECULAR_MAP, STATE};
constexpr SphereBinding TAPS[] = {BACKGROUND, DIFFUSE_MAP, map(&Sources::ladder, true, true),
                                  map(&Sources::clipped_tables, true, true), STATE};
constexpr SphereBinding REFERENCE[] = {BACKGROUND,
                                       storage(&Sources::reference_diffuse, true, false),
                                       storage(&Sources::reference_specular, false, true)};

constexpr SphereMethodEntry METHODS[] = {
    {SphereMethod::kurt2019, KURT2019_SPIRV, KURT2019},
    {SphereMethod::sh2, HARMONICS_SPIRV, HARMONICS, 2},
    {SphereMethod::sh4, HARMONICS_SPIRV, HARMONICS, 4},
    {SphereMethod::plain_split_sum, PLAIN_SPIRV, PLAIN},
    {SphereMethod::split_sum, PREFILTERED_SPIRV, PREFILTERED},
    {SphereMethod::one_tap, TAPS_SPIRV, TAPS, 1},
    {SphereMethod::two_tap, TAPS_SPIRV, TAPS, 2},
    {SphereMethod::hybrid, TAPS_SPIRV, TAPS, 5},
    {SphereMethod::importance, IMPORTANCE_SPIRV, IMPORTANCE},
    {SphereMethod::reference, REFERENCE_SPIRV, REFERENCE},
};

} // namespace

const SphereMethodEntry* find_method(SphereMethod method) noexcept {
    for (const SphereMethodEntry& entry : METHODS)
        if (entry.method == method) return &entry;
    return nullptr;
}

} // namespace lobelia
