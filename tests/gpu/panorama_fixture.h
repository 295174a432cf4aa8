#pragma once

#include <cfloat>

#include <lobelia/panorama.h>

#include "support/environments.h"
#include "support/gpu_sources.h"
#include "support/gpu_test.h"

namespace lobelia::test {
using host::Image;

struct Size {
    std::uint32_t width, height;
};
inline std::ostream& operator<<(std::ostream& out, Size size) {
    return out << size.width << " x " << size.height;
}

inline constexpr Size SMALL_PANORAMAS[] = {{1, 1},  {2, 1},  {1, 2},   {3, 2},    {1, 64},
                                           {64, 1}, {17, 9}, {64, 64}, {300, 100}};

class PanoramaTest : public GpuTest {
protected:
    PanoramaToCube pass = value_of(PanoramaToCube::create(gpu.device()));

    /// Recorded as a whole, or in parts of so many rows, each a submission of its own.
    Image resample(const Image& panorama, std::uint32_t size, std::uint32_t rows = 0) {
        const host::GpuImage source = on_device(gpu, panorama);
        const host::GpuImage target = cube_to_fill(gpu, size);
        const PanoramaToCubeJob job = value_of(pass.bind(panorama_of(source), cube_of(target)));
        if (rows == 0)
            value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
        else
            for (std::uint32_t first = 0; first < job.rows(); first += rows)
                value_of(gpu.submit([&](VkCommandBuffer commands) {
                    job.record(commands, first, std::min(rows, job.rows() - first));
                }));
        return value_of(gpu.download(target, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
    }
};

// Mean over the sphere, each texel weighed by its solid angle.
inline oracle::Rgb mean(const Image& image) {
    oracle::Rgb sum{};
    const int width = int(image.width);
    const int height = int(image.height);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const double solid_angle =
                image.layers == 6 ? oracle::cube_texel_solid_angle(int(x), int(y), width)
                                  : oracle::panorama_texel_solid_angle(int(y), width, height);
            for (std::uint32_t layer = 0; layer < image.layers; ++layer)
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += solid_angle / (4 * oracle::PI) * double(image.texel(layer, x, y)[c]);
        }
    return sum;
}

struct Range {
    float least[3]{FLT_MAX, FLT_MAX, FLT_MAX};
    float most[3]{};
};
inline Range range(const Image& image) {
    Range range;
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        if (i % 4 == 3) continue;
        range.least[i % 4] = std::min(range.least[i % 4], image.texels[i]);
        range.most[i % 4] = std::max(range.most[i % 4], image.texels[i]);
    }
    return range;
}

inline Image noise(Size size, std::uint64_t seed) {
    return image_of(
        oracle::random_panorama(oracle::Scene::noise, int(size.width), int(size.height), seed));
}

} // namespace lobelia::test
