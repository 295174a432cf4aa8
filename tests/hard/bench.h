#pragma once

#include <memory>
#include <optional>
#include <string>

#include <lobelia/host/work.h>
#include <lobelia/map_reader.h>
#include <lobelia/panorama.h>

#include "gpu/furnace.h"
#include "support/exact_averages.h"
#include "support/prefiltered.h"

namespace lobelia::hard {

using oracle::Direction;
using oracle::Rgb;
using oracle::Scene;
using oracle::Source;
using test::Average;
using test::even_cube;
using test::even_panorama;
using test::image_of;
using test::value_of;
using Directions = std::vector<Direction>;

/// Sums of 32-bit numbers in a row, of which none is longer than this, lose so much of themselves.
constexpr double SUMMATION = 300 * 0x1p-24;

/// Half of the distance of halves, relative: what a map of halves is off by at least.
constexpr double HALF = 0x1p-11;

/// What rows are run on: the library's passes on one device, made when first asked for, since they
/// cost more than most rows.
class Bench {
public:
    host::Gpu& gpu();
    bool has_gpu() const { return bool(gpu_); }

    /// The exact path, at any axes.
    std::vector<Average> exact(const host::Image& image, float exponent, const Directions& axes);
    std::vector<Average> exact(const Source& source, float exponent, const Directions& axes) {
        return exact(image_of(source), exponent, axes);
    }
    const Exact& exact();

    /// The prefilter's maps of a cube map, and what the installed GLSL reads from one.
    test::Prefiltered maps(const host::Image& cube, const test::Wanted& wanted);
    std::vector<Average> read(const test::Prefiltered& maps, std::size_t index,
                              const Directions& axes);
    host::Image stored(const test::Prefiltered& maps, std::size_t index);

    /// A panorama made into a cube map.
    host::Image cube(const host::Image& panorama, std::uint32_t face);

private:
    std::optional<host::Gpu> gpu_;
    std::optional<Exact> exact_;
    std::optional<Prefilter> prefilter_;
    std::optional<MapReader> reader_;
    std::optional<PanoramaToCube> to_cube_;
};

/// The sphere under maps that hold one light everywhere: kd + ks W(N.R, n) times that light.
class EvenSphere {
public:
    EvenSphere(Bench& bench, std::uint32_t width, std::uint32_t height, bool background = true)
        : bench_(bench), width_(width), height_(height),
          picture_(bench.gpu(), width, height, {.background = background}) {}

    /// The view's size and background are those of the sphere.
    host::Image draw(const SphereView& view, float light = 1.0f) const;

private:
    Bench& bench_;
    std::uint32_t width_, height_;
    test::SpherePicture picture_;
};

/// The one of the program.
Bench& bench();
/// Lets it go. Not left to the end of the program, when the validation layer has ended already.
void close_bench();

/// Colours one after the other, for Findings::sound().
std::vector<float> colours(const std::vector<Average>& averages);

/// `count` axes as 32-bit floats, +-X, +-Y, +-Z first, the others at random.
Directions axes(int count, std::uint64_t seed);

std::string text(float value);

} // namespace lobelia::hard
