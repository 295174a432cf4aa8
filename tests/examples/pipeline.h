// A graphics pipeline of the engine's, with one set of descriptors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine.h"

extern const std::span<const std::uint32_t> MESH_VERTEX, MESH_FRAGMENT, BACKGROUND_VERTEX,
    BACKGROUND_FRAGMENT;

/// What a binding refers to.
struct Resource {
    VkImageView view = VK_NULL_HANDLE; // with a linear sampler
    VkSamplerAddressMode addressing = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkBuffer buffer = VK_NULL_HANDLE;
};
inline Resource image(const Image& image,
                      VkSamplerAddressMode addressing = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE) {
    return {.view = image.view, .addressing = addressing};
}
inline Resource uniform(const Buffer& buffer) {
    return {.buffer = buffer.handle};
}

/// Draws on a Canvas with depth.
struct Pipeline {
    struct Description {
        std::span<const std::uint32_t> vertex, fragment;
        std::vector<Resource> resources;  // of the fragment shader, by binding
        std::uint32_t push_constants = 0; // bytes, for both
        bool vertices = false;            // of shapes.h; else none
        std::uint32_t constant = 0;       // the fragment shader's constant 0
    };
    VkDescriptorSetLayout set_layout;
    VkDescriptorPool pool;
    VkDescriptorSet set;
    std::vector<VkSampler> samplers;
    VkPipelineLayout layout;
    VkPipeline handle;
    std::uint32_t push_constants;

    static Pipeline create(const Engine& engine, const Description& description);
    void bind(VkCommandBuffer commands, const void* push_constants) const;
    void destroy(const Engine& engine) const;
};
