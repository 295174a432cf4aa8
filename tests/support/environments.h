#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "support/source.h"

namespace lobelia::oracle {

/// Numbers that are the same on every machine for the same seed.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double unit() { return double(engine_() >> 11) * 0x1p-53; } // [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int count) { return int(unit() * count); }
    Direction direction(); // uniform over the sphere
    /// Uniform over the half sphere around `axis`.
    Direction direction_above(Direction axis);

private:
    std::mt19937_64 engine_;
};

/// `count` directions, uniform over the sphere; the first six are +X -X +Y -Y +Z -Z.
std::vector<Direction> test_directions(int count, std::uint64_t seed);

/// An environment whose texels hold `radiance` of their middles, rounded to float.
Source panorama_of(int width, int height, const std::function<Rgb(Direction)>& radiance);
Source cube_of(int size, const std::function<Rgb(Direction)>& radiance);

/// Kinds of random environments. Every radiance is a float, at least 0.
enum class Scene {
    smooth, // spherical harmonics to degree 4 over a grey level, between 0 and 2
    noise,  // texels apart, over four decades
    suns,   // a dark sky of noise around 0.1 with one to five texels from 1e2 to 1e9
    halves, // bright above a random plane, black below
};
inline constexpr Scene ALL_SCENES[] = {Scene::smooth, Scene::noise, Scene::suns, Scene::halves};
const char* name(Scene scene);

/// The same scene for the same seed. Smooth and halves do not depend on the size but for sampling.
Source random_panorama(Scene scene, int width, int height, std::uint64_t seed);
Source random_cube(Scene scene, int size, std::uint64_t seed);

} // namespace lobelia::oracle
