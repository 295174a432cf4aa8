#pragma once

#include <compare>
#include <map>

#include "owned.h"

#include <lobelia/host/gpu.h>

namespace lobelia::cli {

/// What display.frag is compiled for; its specialisation constants.
struct DisplayVariant {
    std::uint32_t split = 0;
    std::uint32_t errors = 0;
    std::uint32_t exact = 0;
    std::uint32_t encode = 1;

    auto operator<=>(const DisplayVariant&) const = default;
};

/// Its push constants.
struct DisplayParams {
    float scale = 1.0f;
    float divider = 0.0f;
    float dark = 0.0f;
    std::uint32_t width = 0;
};

/// What display.frag reads: views in SHADER_READ_ONLY_OPTIMAL and a buffer of a word a pixel.
struct DisplaySources {
    VkImageView first = VK_NULL_HANDLE;
    VkImageView second = VK_NULL_HANDLE;
    VkImageView reference = VK_NULL_HANDLE;
    VkBuffer known = VK_NULL_HANDLE;
};

/// Draws pictures as a person sees them.
class Display {
public:
    /// Into the colour attachment of `pass`, which outlives this.
    static host::Outcome<Display> create(VkDevice device, VkRenderPass pass);

    /// For the next draw. The last one has ended.
    host::Outcome<Done> bind(const DisplaySources& sources, const DisplayVariant& variant);
    void record(VkCommandBuffer commands, const DisplayParams& params, VkExtent2D extent) const;

private:
    Display(VkDevice device, VkRenderPass pass) : device_(device), pass_(pass) {}
    host::Outcome<Done> make_set();
    host::Outcome<Done> make_layout();

    VkDevice device_;
    VkRenderPass pass_;
    OwnedSampler sampler_;
    OwnedSetLayout set_layout_;
    OwnedPipelineLayout layout_;
    OwnedDescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    std::map<DisplayVariant, OwnedPipeline> pipelines_; // compiled when first asked for
    VkPipeline pipeline_ = VK_NULL_HANDLE;              // of the last bind()
};

} // namespace lobelia::cli
