#include "support/environments.h"

#include <algorithm>

#include "support/harmonics.h"

namespace lobelia::oracle {
namespace {

// Through floats in memory: GCC 12 at -O2 takes double(float(x)) for x on pairs of numbers.
Source as_floats(const Source& source) {
    const std::vector<float> rgba = source.rgba();
    return source.is_cube() ? Source::cube(source.width(), rgba)
                            : Source::panorama(source.width(), source.height(), rgba);
}

Source make(bool cube, int width, int height, const std::function<Rgb(Direction)>& radiance) {
    std::vector<Rgb> texels;
    for (int face = 0; face < (cube ? 6 : 1); ++face)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                texels.push_back(
                    radiance(cube ? cube_direction(face, x + 0.5, y + 0.5, width)
                                  : panorama_direction(x + 0.5, y + 0.5, width, height)));
    return as_floats(cube ? Source::cube(width, std::move(texels))
                          : Source::panorama(width, height, std::move(texels)));
}

std::function<Rgb(Direction)> smooth(Random& random) {
    std::vector<Rgb> coefficients(25);
    for (Rgb& coefficient : coefficients)
        for (double& channel : coefficient) channel = random.between(-0.4, 0.4);
    return [coefficients](Direction d) {
        Rgb sum{1, 1, 1};
        for (int l = 1; l <= 4; ++l)
            for (int m = -l; m <= l; ++m)
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += coefficients[std::size_t(l * l + l + m)][c] * harmonic(l, m, d);
        for (double& channel : sum) channel = std::clamp(channel, 0.0, 2.0);
        return sum;
    };
}

std::function<Rgb(Direction)> noise(Random& random, double low, double high) {
    return [&random, low, high](Direction) {
        Rgb value{};
        for (double& channel : value)
            channel = std::exp(random.between(std::log(low), std::log(high)));
        return value;
    };
}

Source random_source(bool cube, Scene scene, int width, int height, std::uint64_t seed) {
    Random random(seed);
    switch (scene) {
    case Scene::smooth: return make(cube, width, height, smooth(random));
    case Scene::noise: return make(cube, width, height, noise(random, 1e-2, 1e2));
    case Scene::halves: {
        const Direction axis = random.direction();
        const Rgb colour{random.between(0.1, 2), random.between(0.1, 2), random.between(0.1, 2)};
        return make(cube, width, height,
                    [=](Direction d) { return dot(d, axis) > 0 ? colour : Rgb{}; });
    }
    case Scene::suns: break;
    }
    Source source = make(cube, width, height, noise(random, 0.05, 0.2));
    const int count = 1 + random.below(5);
    for (int i = 0; i < count; ++i) {
        const double peak = std::pow(10, random.between(2, 9));
        const int layer = random.below(source.layers());
        const int x = random.below(width);
        const int y = random.below(height);
        source.texel(layer, x, y) = {peak, peak * random.between(0.5, 1),
                                     peak * random.between(0.2, 1)};
    }
    return as_floats(source);
}

} // namespace

Direction Random::direction() {
    const double y = between(-1, 1);
    const double longitude = between(-PI, PI);
    const double across = std::sqrt((1 - y) * (1 + y));
    return {across * std::sin(longitude), y, across * std::cos(longitude)};
}

Direction Random::direction_above(Direction axis) {
    const Direction d = direction();
    return dot(d, axis) < 0 ? -1.0 * d : d;
}

std::vector<Direction> test_directions(int count, std::uint64_t seed) {
    std::vector<Direction> directions{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                      {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    Random random(seed);
    directions.resize(std::size_t(std::min(count, 6)));
    while (directions.size() < std::size_t(count)) directions.push_back(random.direction());
    return directions;
}

Source panorama_of(int width, int height, const std::function<Rgb(Direction)>& radiance) {
    return make(false, width, height, radiance);
}
Source cube_of(int size, const std::function<Rgb(Direction)>& radiance) {
    return make(true, size, size, radiance);
}

const char* name(Scene scene) {
    switch (scene) {
    case Scene::smooth: return "smooth";
    case Scene::noise: return "noise";
    case Scene::suns: return "suns";
    case Scene::halves: return "halves";
    }
    return "";
}

Source random_panorama(Scene scene, int width, int height, std::uint64_t seed) {
    return random_source(false, scene, width, height, seed);
}
Source random_cube(Scene scene, int size, std::uint64_t seed) {
    return random_source(true, scene, size, size, seed);
}

} // namespace lobelia::oracle
