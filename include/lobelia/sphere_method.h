#pragma once

#include <cstdint>

#include <vulkan/vulkan_core.h>

#include <lobelia/prefilter.h>

namespace lobelia {

/// How the sphere's colour is found.
enum class SphereMethod : std::uint32_t {
    kurt2019, // six colours, as in the paper of the material (lobelia/kurt2019.glsl)
    sh2,      // kd by spherical harmonics of degree 2 (lobelia/irradiance.glsl), ks as split_sum
    sh4,      // the same with degree 4
    plain_split_sum, // kd P_1(N) + ks W(N.R, n) P_n(R), from maps that hold these averages
    split_sum,       // the same from Prefilter's maps, their scale and suns
    one_tap,         // lobelia/taps.glsl: the lobe as the horizon cuts it, by one lobe of a ladder,
    two_tap,         // two
    hybrid,          // or five, and the suns exactly
    importance,      // filtered importance sampling at run time (lobelia/importance_shading.glsl)
    reference,       // the same sum with the integrals of Exact, one value per pixel
};

/// What the pass is compiled for. A part that is left out costs no fetch and no code.
struct SphereShading {
    SphereMethod method = SphereMethod::plain_split_sum;
    bool diffuse = true;    // else kd counts as 0
    bool specular = true;   // else ks counts as 0
    bool background = true; // else nothing is drawn behind the sphere
    /// How `specular`, one of Prefilter's maps, is read; other maps are read bilinearly.
    MapFilter specular_filter = MapFilter::bilinear;
    bool suns = true; // one_tap and better: else the maps have none (the prefilter's state says)
    std::uint32_t samples = 64; // fetches of each lobe by SphereMethod::importance
    static constexpr std::uint32_t MOST_SAMPLES = 1024;

    bool operator==(const SphereShading&) const = default;
};

/// What the sphere pass reads; cube views in SHADER_READ_ONLY_OPTIMAL, of formats that can be
/// filtered. What the method does not read, or reads for a lobe that SphereShading leaves out, may
/// be null; `background` is always there, since it also stands in for maps that are not.
struct SphereSources {
    VkImageView background = VK_NULL_HANDLE; // the environment

    /// kurt2019: the environment averaged (Mips, with MipWeights::equal); its last level is read.
    VkImageView blurred = VK_NULL_HANDLE;

    /// sh2 and sh4: what Irradiance makes, a uniform buffer.
    VkBuffer irradiance = VK_NULL_HANDLE;

    /// Both split sums: P_1 and P_n; sh2 and sh4: P_n. `prefilter_state` is Prefilter's state
    /// buffer, a uniform buffer here.
    VkImageView diffuse = VK_NULL_HANDLE;
    VkImageView specular = VK_NULL_HANDLE;
    VkBuffer prefilter_state = VK_NULL_HANDLE;

    /// importance: the environment with all its levels, as Mips makes them.
    VkImageView mips = VK_NULL_HANDLE;
    /// one_tap, two_tap and hybrid: `diffuse` and `prefilter_state` as above, 2D array views of
    /// Prefilter's ladder and of ClippedTables' image, both also without a specular lobe.
    VkImageView ladder = VK_NULL_HANDLE;
    VkImageView clipped_tables = VK_NULL_HANDLE;

    /// reference: results of Exact, entry y * width + x for pixel (x, y): averages of the lobe of
    /// exponent 1 about the normal N, and of the exponent n about the mirror direction R, clipped
    /// by the horizon of N. At least one of them is there.
    VkBuffer reference_diffuse = VK_NULL_HANDLE;
    VkBuffer reference_specular = VK_NULL_HANDLE;
};

} // namespace lobelia
