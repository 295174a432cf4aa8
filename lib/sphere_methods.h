#pragma once

#include <cstdint>
#include <span>

#include <lobelia/sphere_method.h>

namespace lobelia {

/// What one binding of a method's fragment shader refers to: a view or a buffer of SphereSources,
/// and the lobes that it lights. Where the shading has none of those it may be null, and another
/// resource of the same type stands in, since some drivers read descriptors that the shader does
/// not; for views that is the background, so only cubes may be left out.
struct SphereBinding {
    VkDescriptorType type;
    VkImageView SphereSources::*view = nullptr;
    VkBuffer SphereSources::*buffer = nullptr;
    bool diffuse = true;
    bool specular = true;
};

/// A way to draw the sphere, as data: its fragment shader, and what that reads. Binding 0 is the
/// background. `variant` is the shader's specialisation constant 4, where methods share one.
struct SphereMethodEntry {
    SphereMethod method;
    std::span<const std::uint32_t> spirv;
    std::span<const SphereBinding> bindings;
    std::uint32_t variant = 0;
};

/// The entry of a method; nothing for a value that is none.
const SphereMethodEntry* find_method(SphereMethod method) noexcept;

} // namespace lobelia
