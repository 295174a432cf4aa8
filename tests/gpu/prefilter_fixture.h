#pragma once

#include <vector>

#include "support/environments.h"
#include "support/gpu_test.h"
#include "support/prefiltered.h"
#include "vk/compute_pass.h"

namespace lobelia::test {

/// Prefilters cubes and reads the maps as an engine does.
class PrefilterTest : public GpuTest {
protected:
    using Average = std::array<float, 4>; // R G B 1
    using Directions = std::vector<oracle::Direction>;

    Prefilter prefilter = value_of(Prefilter::create(gpu.device()));

    host::GpuBuffer storage(VkDeviceSize bytes, VkBufferUsageFlags more = 0) {
        return test::storage(gpu, bytes, more);
    }
    std::vector<host::GpuImage> images_for(const PrefilterPlan& plan) {
        return test::images_for(gpu, plan);
    }

    /// `split` says how many passes each submission records; what is left goes into the last.
    Prefiltered make(const host::GpuImage& source, const Wanted& wanted,
                     const std::vector<std::uint32_t>& split = {}) {
        return make_maps(gpu, prefilter, source, wanted, split);
    }
    Prefiltered make(const host::Image& source, const Wanted& wanted) {
        return make(on_device(gpu, source), wanted);
    }

    /// Map number `map` as it is stored.
    host::Image stored(const Prefiltered& made, std::size_t map) {
        return value_of(gpu.download(made.maps[map], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
    }
    /// Map number `map` as the installed GLSL reads it.
    std::vector<Average> read(const Prefiltered& made, std::size_t map, const Directions& axes);

private:
    static constexpr VkDescriptorType READ_BINDINGS[] = {
        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    struct ReadParams {
        float exponent;
        std::uint32_t spline;
    };

    vk::Context context_ = vk::load(gpu.device());
    vk::Sampler linear_ = vk::make_sampler(context_, VK_FILTER_LINEAR);
    vk::ComputePass reading_ = make_reading(context_);

    static vk::ComputePass make_reading(const vk::Context& context);
};

} // namespace lobelia::test
