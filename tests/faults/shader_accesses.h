#pragma once

#include <cstdint>
#include <map>
#include <span>

namespace lobelia::test {

/// What a shader may do with one of its bindings, by its declaration.
struct BindingUse {
    bool reads = true;
    bool writes = true;
};

/// By binding of set 0: images and buffers that the shader declares; `readonly` and `writeonly`
/// show as NonWritable and NonReadable. Sampled images and texel buffers are not told apart here.
std::map<std::uint32_t, BindingUse> shader_accesses(std::span<const std::uint32_t> spirv);

} // namespace lobelia::test
