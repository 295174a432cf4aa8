#pragma once

#include "owned.h"

#include <lobelia/host/gpu.h>

namespace lobelia::cli {

/// How display.frag shows the pictures; its push constants.
struct DisplayParams {
    float scale = 1.0f;
    float divider = 0.0f;
    std::uint32_t errors = 0;
    std::uint32_t exact = 0;
    float dark = 0.0f;
    std::uint32_t encode = 1;
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
    /// Into the colour attachment of `pass`.
    static host::Outcome<Display> create(VkDevice device, VkRenderPass pass);

    /// The last draw has ended.
    void bind(const DisplaySources& sources);
    void record(VkCommandBuffer commands, const DisplayParams& params, VkExtent2D extent) const;

private:
    explicit Display(VkDevice device) : device_(device) {}
    host::Outcome<Done> make_set();
    host::Outcome<Done> make_pipeline(VkRenderPass pass);

    VkDevice device_;
    OwnedSampler sampler_;
    OwnedSetLayout set_layout_;
    OwnedPipelineLayout layout_;
    OwnedDescriptorPool pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    OwnedPipeline pipeline_;
};

} // namespace lobelia::cli
