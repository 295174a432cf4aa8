#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vk/debug.h"
#include "vk/guard.h"
#include "vk/unique.h"

namespace lobelia::vk {

template <class Handle, auto destroy>
using Object = Unique<Context, Handle, destroy>;

using BufferView = Object<VkBufferView, &Functions::vkDestroyBufferView>;
using DescriptorPool = Object<VkDescriptorPool, &Functions::vkDestroyDescriptorPool>;
using ImageView = Object<VkImageView, &Functions::vkDestroyImageView>;
using Pipeline = Object<VkPipeline, &Functions::vkDestroyPipeline>;
using PipelineLayout = Object<VkPipelineLayout, &Functions::vkDestroyPipelineLayout>;
using Sampler = Object<VkSampler, &Functions::vkDestroySampler>;
using SetLayout = Object<VkDescriptorSetLayout, &Functions::vkDestroyDescriptorSetLayout>;
using ShaderModule = Object<VkShaderModule, &Functions::vkDestroyShaderModule>;

/// Makes one Vulkan object: `create(device, create info, allocator, handle)`.
template <class Owner, class Create, class Info>
Owner make(const Context& context, Create create, const Info& info, const char* step) {
    decltype(std::declval<Owner>().get()) handle = VK_NULL_HANDLE;
    check(create(context.device.handle, &info, context.device.allocator, &handle), step);
    return Owner(context, handle);
}

ShaderModule make_shader_module(const Context& context, std::span<const std::uint32_t> spirv);

/// A sampler that clamps to the edge, with one filter for everything.
Sampler make_sampler(const Context& context, VkFilter filter);

/// One descriptor set layout and pipeline layout: entry `i` of `bindings` is binding `i` of set 0,
/// and `push_constant_size` bytes are visible to `stages`.
struct Interface {
    SetLayout set_layout;
    PipelineLayout layout;
};
Interface make_interface(const Context& context, const char* name, VkShaderStageFlags stages,
                         std::span<const VkDescriptorType> bindings,
                         std::uint32_t push_constant_size);

/// What one binding of a descriptor set refers to: an image (view, sampler, layout), a buffer, or a
/// buffer read as texels.
struct Resource {
    VkDescriptorImageInfo image{};
    VkDescriptorBufferInfo buffer{};
    VkBufferView texels = VK_NULL_HANDLE;
};
inline Resource storage_image(VkImageView view) {
    return {.image = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}};
}
inline Resource sampled_image(VkImageView view, VkSampler sampler) {
    return {.image = {sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
}
inline Resource buffer_range(VkBuffer buffer, VkDeviceSize offset = 0,
                             VkDeviceSize size = VK_WHOLE_SIZE) {
    return {.buffer = {buffer, offset, size}};
}

inline Resource texel_buffer(VkBufferView view) {
    return {.texels = view};
}

/// A pool with `sets` descriptor sets for `interface`, whose binding `i` has type `bindings[i]`.
struct DescriptorSets {
    DescriptorPool pool;
    std::vector<VkDescriptorSet> sets;
};
DescriptorSets make_descriptor_sets(const Context& context, const Interface& interface,
                                    std::span<const VkDescriptorType> bindings, std::uint32_t sets);

/// One such set, whose binding `i` refers to `resources[i]`.
DescriptorSets make_descriptor_set(const Context& context, const Interface& interface,
                                   std::span<const VkDescriptorType> bindings,
                                   std::span<const Resource> resources);

/// Points binding `i` of `set` (of type `bindings[i]`) to `resources[i]`.
void write_descriptor_set(const Context& context, VkDescriptorSet set,
                          std::span<const VkDescriptorType> bindings,
                          std::span<const Resource> resources);

} // namespace lobelia::vk
