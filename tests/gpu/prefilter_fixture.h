#pragma once

#include <cstring>
#include <vector>

#include <lobelia/prefilter.h>

#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"
#include "support/shared.h"
#include "vk/compute_pass.h"

namespace lobelia {

#define SHARED inline
#include "lobelia/suns.glsl"
#undef SHARED

namespace test {

/// Maps on the device, with what belongs to them.
struct Prefiltered {
    PrefilterPlan plan;
    std::vector<host::GpuImage> maps;
    host::GpuBuffer state;

    const PrefilterState& found() const {
        return *reinterpret_cast<const PrefilterState*>(state.data());
    }
};

/// What is asked for; a PrefilterRequest that owns its list.
struct Wanted {
    std::vector<float> exponents;
    bool lambert = false;
    Quality quality = Quality::normal;
};

/// Prefilters cubes and reads the maps as an engine does.
class PrefilterTest : public GpuTest {
protected:
    using Average = std::array<float, 4>; // R G B 1
    using Directions = std::vector<oracle::Direction>;

    Prefilter prefilter = value_of(Prefilter::create(gpu.device()));

    static PrefilterPlan plan_for(const Wanted& wanted, std::uint32_t source_size) {
        return value_of(PrefilterPlan::make({.exponents = wanted.exponents,
                                             .lambert = wanted.lambert,
                                             .quality = wanted.quality,
                                             .source_size = source_size}));
    }
    std::vector<host::GpuImage> images_for(const PrefilterPlan& plan);
    host::GpuBuffer storage(VkDeviceSize bytes, VkBufferUsageFlags more = 0);

    /// `split` says how many passes each submission records; what is left goes into the last.
    Prefiltered make(const host::GpuImage& source, const Wanted& wanted,
                     const std::vector<std::uint32_t>& split = {});
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

    vk::Context context_ = value_of(vk::load(gpu.device()));
    vk::Sampler linear_ = value_of(vk::make_sampler(context_, VK_FILTER_LINEAR));
    vk::ComputePass reading_ = make_reading(context_);

    static vk::ComputePass make_reading(const vk::Context& context);
};

/// An even cube map.
inline host::Image even_cube(std::uint32_t size, float red, float green, float blue) {
    host::Image image = even_panorama(size, 6 * size, red, green, blue);
    return {host::Layout::cube, size, size, 6, std::move(image.texels)};
}

/// The middles of a cube map's texels, in the order of its texels.
inline std::vector<oracle::Direction> texel_directions(int size) {
    std::vector<oracle::Direction> directions;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                directions.push_back(oracle::cube_direction(face, x + 0.5, y + 0.5, size));
    return directions;
}

} // namespace test
} // namespace lobelia
