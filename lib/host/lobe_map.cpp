#include "host/lobe_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <thread>

#include "host/directions.h"

namespace lobelia::host {

namespace {

constexpr std::uint32_t LEAST_FACE = 16;
constexpr std::uint32_t TILE = 8;    // texels of an edge
constexpr double LAST_WEIGHT = 1e-6; // of the peak; what is below is left out
constexpr double LAST_POWER = 14.0;  // its logarithm, as a power of e

/// A square of texels and the cone about it.
struct Tile {
    Vector axis;
    double radius; // radians
    std::vector<std::size_t> texels;
};

std::vector<Tile> tiles(const std::vector<Vector>& directions, std::uint32_t face) {
    std::vector<Tile> all;
    for (std::size_t layer = 0; layer < 6; ++layer)
        for (std::uint32_t top = 0; top < face; top += TILE)
            for (std::uint32_t left = 0; left < face; left += TILE) {
                Tile tile{};
                for (std::uint32_t y = top; y < std::min(top + TILE, face); ++y)
                    for (std::uint32_t x = left; x < std::min(left + TILE, face); ++x)
                        tile.texels.push_back((layer * face + y) * face + x);
                for (const std::size_t i : tile.texels) tile.axis = tile.axis + directions[i];
                tile.axis = normalised(tile.axis);
                for (const std::size_t i : tile.texels)
                    tile.radius = std::max(
                        tile.radius,
                        2.0 * std::asin(std::min(0.5 * length(directions[i] - tile.axis), 1.0)));
                all.push_back(std::move(tile));
            }
    return all;
}

/// A texel of the source: where it is, and its light with its solid angle.
struct Emitter {
    Vector direction;
    double light[3];
    double solid_angle;
};

class Filter {
public:
    Filter(const Image& cube, float exponent, std::uint32_t face)
        : exponent_(double(exponent)),
          target_directions_(texel_directions(Layout::cube, face, face)),
          source_directions_(texel_directions(Layout::cube, cube.width, cube.width)), cube_(cube),
          targets_(tiles(target_directions_, face)),
          sources_(tiles(source_directions_, cube.width)), solid_angles_(solid_angles(cube.width)) {
        const double least_cosine =
            exponent > 0.0f ? std::pow(LAST_WEIGHT, 1.0 / double(exponent)) : 0.0;
        // However sharp the lobe, the texel that its axis meets is near: half a diagonal away.
        reach_ = std::acos(least_cosine) + std::numbers::sqrt2 / cube.width;
    }

    void run(Image& target, std::size_t first, std::size_t step) const {
        for (std::size_t i = first; i < targets_.size(); i += step) {
            const std::vector<Emitter> near = emitters_near(targets_[i]);
            for (const std::size_t texel : targets_[i].texels)
                average(near, target_directions_[texel], &target.texels[4 * texel]);
        }
    }

private:
    std::vector<Emitter> emitters_near(const Tile& target) const {
        std::vector<Emitter> near;
        for (const Tile& source : sources_) {
            const double reach = reach_ + target.radius + source.radius;
            if (reach < 3.0 && dot(source.axis, target.axis) < std::cos(reach)) continue;
            for (const std::size_t i : source.texels) {
                const float* const light = &cube_.texels[4 * i];
                near.push_back({source_directions_[i],
                                {double(light[0]), double(light[1]), double(light[2])},
                                solid_angles_[i % solid_angles_.size()]});
            }
        }
        return near;
    }

    // Weights are relative to the largest one, so that the sharpest lobe keeps its nearest texel.
    void average(const std::vector<Emitter>& emitters, Vector axis, float* result) const {
        double least = 0.999;
        for (const Emitter& emitter : emitters) least = std::min(least, chord(emitter, axis));
        const double peak = exponent_ * std::log1p(-least);
        double sum[3] = {}, weights = 0.0;
        for (const Emitter& emitter : emitters) {
            const double distance = chord(emitter, axis);
            // log(1 - t) falls faster than -t, so what this skips is below the last weight.
            if (distance >= 1.0 || exponent_ * (distance - least) > LAST_POWER) continue;
            const double power = exponent_ * std::log1p(-distance) - peak;
            const double weight = emitter.solid_angle * std::exp(power);
            for (int i = 0; i < 3; ++i) sum[i] += weight * emitter.light[i];
            weights += weight;
        }
        for (int i = 0; i < 3; ++i) result[i] = float(sum[i] / weights);
    }

    static double chord(const Emitter& emitter, Vector axis) {
        const Vector difference = emitter.direction - axis;
        return 0.5 * dot(difference, difference);
    }

    double exponent_;
    double reach_;
    std::vector<Vector> target_directions_, source_directions_;
    const Image& cube_;
    std::vector<Tile> targets_, sources_;
    std::vector<double> solid_angles_; // of one face
};

} // namespace

std::uint32_t lobe_face(float exponent, std::uint32_t largest) {
    const double needed = std::min(4.0 * std::sqrt(double(exponent)), double(largest));
    return std::max(std::bit_ceil(std::uint32_t(std::ceil(needed))), LEAST_FACE);
}

Image lobe_map(const Image& cube, float exponent, std::uint32_t face) {
    const std::uint32_t needed = 2 * lobe_face(exponent, cube.width);
    const bool reducible = needed < cube.width && cube.width % needed == 0;
    const Image reduced = reducible ? reduced_cube(cube, needed) : Image{};
    const Filter filter(reducible ? reduced : cube, exponent, face);

    Image target{Layout::cube, face, face, 6,
                 std::vector<float>(std::size_t(4) * 6 * face * face, 1.0f)};
    std::thread other([&] { filter.run(target, 1, 2); });
    filter.run(target, 0, 2);
    other.join();
    return target;
}

} // namespace lobelia::host
