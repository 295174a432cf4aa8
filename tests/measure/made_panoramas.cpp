#include "made_panoramas.h"

#include <cmath>

#include "support/environments.h"
#include "support/gpu_sources.h"

namespace lobelia::test {
namespace {

using oracle::Direction;
using oracle::Random;
using oracle::Rgb;

constexpr int WIDTH = 1024, HEIGHT = 512;

Rgb grey(double light) {
    return {light, 0.9 * light, 0.8 * light};
}

host::Image image_by(const std::function<Rgb(Direction)>& radiance) {
    return image_of(oracle::panorama_of(WIDTH, HEIGHT, radiance));
}

/// Every second field of a grid of 16 x 8 holds a lamp of 10 x 10 texels.
host::Image lamps() {
    host::Image image = image_by([](Direction) { return grey(0.05); });
    for (int row = 0; row < 8; ++row)
        for (int column = row % 2; column < 16; column += 2)
            for (int y = 0; y < 10; ++y)
                for (int x = 0; x < 10; ++x) {
                    float* texel = image.texel(0, std::uint32_t(64 * column + 27 + x),
                                               std::uint32_t(64 * row + 27 + y));
                    for (int c = 0; c < 3; ++c) texel[c] = float(20 + 5 * ((row + c) % 3));
                }
    return image;
}

/// Three bright rectangles, one of them 3 degrees wide, in a dim room that is lighter above.
host::Image soft_boxes() {
    struct Box {
        Direction middle;
        double tangent_across, tangent_along, light;
    };
    const Box boxes[] = {{oracle::normalised({1, 0.8, 0.3}), 0.3, 0.2, 60},
                         {oracle::normalised({-0.7, 0.2, 0.9}), 0.026, 0.5, 150},
                         {oracle::normalised({0.1, 1, -0.9}), 0.15, 0.15, 25}};
    return image_by([&](Direction d) {
        for (const Box& box : boxes) {
            const Direction across = oracle::normalised({box.middle.z, 0, -box.middle.x});
            const Direction along = cross(box.middle, across);
            const double depth = dot(d, box.middle);
            if (depth > 0 && std::abs(dot(d, across)) < box.tangent_across * depth &&
                std::abs(dot(d, along)) < box.tangent_along * depth)
                return grey(box.light);
        }
        return grey(0.1 + 0.05 * d.y);
    });
}

/// Light over three decades from texel to texel, and four suns of 2 x 2 texels.
host::Image noise_and_suns() {
    Random random(21);
    host::Image image = image_by([&](Direction) {
        Rgb value{};
        for (double& channel : value) channel = std::exp(random.between(-5, 2));
        return value;
    });
    for (const double light : {2e3, 3e4, 4e5, 5e6}) {
        const auto x = std::uint32_t(random.below(WIDTH - 1));
        const auto y = std::uint32_t(random.below(HEIGHT - 1));
        for (std::uint32_t i = 0; i < 4; ++i)
            for (int c = 0; c < 3; ++c)
                image.texel(0, x + i % 2, y + i / 2)[c] = float(light / (1 + c));
    }
    return image;
}

/// A clear sky with a sun of half a degree over a dark ground with a sharp horizon.
host::Image clear_sky() {
    const Direction sun = oracle::normalised({0.5, 0.4, -0.7});
    return image_by([&](Direction d) {
        if (d.y < 0) return Rgb{0.03, 0.025, 0.02};
        const double glow = std::exp(8 * (dot(d, sun) - 1));
        Rgb light{0.3 + glow, 0.5 + 0.9 * glow, 1 + 0.7 * glow};
        if (dot(d, sun) > std::cos(0.0045)) light = {5e4, 4.5e4, 4e4};
        return light;
    });
}

} // namespace

std::vector<MadePanorama> made_panoramas() {
    return {{"lamps", lamps()},
            {"soft boxes", soft_boxes()},
            {"noise and suns", noise_and_suns()},
            {"clear sky", clear_sky()}};
}

} // namespace lobelia::test
