#include "checked_panoramas.h"

#include <cmath>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

using oracle::Direction;
using oracle::Rgb;

host::Image sky_with_suns(int width) {
    host::Image image = image_of(oracle::panorama_of(width, width / 2, [](Direction d) {
        return d.y > 0 ? Rgb{0.4, 0.6, 0.6 + d.y} : Rgb{0.05, 0.04 + 0.02 * d.x, 0.03};
    }));
    const auto across = std::uint32_t(width);
    std::uint32_t step = 1;
    for (const float light : {3e3f, 4e4f, 5e5f}) {
        float* texel = image.texel(0, across * step / 5 + step, across / 2 * step / 8 + 2);
        for (int c = 0; c < 3; ++c) texel[c] = light / float(1 + c);
        ++step;
    }
    return image;
}

host::Image room_with_window(int width) {
    host::Image image = image_of(oracle::panorama_of(width, width / 2, [](Direction d) {
        const double across = d.z / d.x, up = d.y / d.x; // in the plane of the wall at +X
        const bool bars = std::abs(across) < 0.03 || std::abs(up - 0.3) < 0.03;
        if (d.x > 0 && std::abs(across) < 0.5 && std::abs(up - 0.3) < 0.4 && !bars)
            return Rgb{22, 28, 40};
        if (d.y < -0.5 && std::abs(d.x / d.y + 0.3) < 0.3 && std::abs(d.z / d.y) < 0.3)
            return Rgb{3, 3.4, 4};
        return Rgb{0.09 + 0.03 * d.x, 0.08, 0.07 + 0.02 * d.y};
    }));
    for (std::uint32_t i = 0; i < 9; ++i) {
        float* texel =
            image.texel(0, std::uint32_t(width) / 9 + i % 3, std::uint32_t(width) / 4 + i / 3);
        texel[0] = 900;
        texel[1] = 500;
        texel[2] = 150;
    }
    return image;
}

} // namespace lobelia::test
