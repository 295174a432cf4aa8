#pragma once

#include <random>

#include "support/shared.h"

namespace lobelia {

inline constexpr double LAST_PLACES = 4e-7; // a few units in the last place of a number next to 1

inline vec3 random_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return normalize(vec3(normal(random), normal(random), normal(random)));
}

} // namespace lobelia
