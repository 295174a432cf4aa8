#include <cfloat>
#include <cmath>
#include <limits>

#include <lobelia/host/read.h>

#include "bench.h"
#include "catalogue.h"
#include "gpu/panorama_fixture.h"
#include "host/sanitise.h"
#include "odd_floats.h"
#include "support/oracle.h"
#include "support/run_program.h"

// B05 to B13, B21, B22: the values of texels.
namespace lobelia::hard {
namespace {

// A map with one odd channel in it, and what the rule makes of it.
void sanitised(Bench& bench, Findings& found, float odd, float becomes,
               std::uint64_t host::Sanitised::*counter) {
    const host::Image clean = image_of(oracle::random_cube(Scene::noise, 16, 25));
    for (std::size_t channel = 0; channel < 3; ++channel) {
        found.at(text(odd) + " in channel " + std::to_string(channel));
        host::Image expected = clean, image = clean;
        float largest = 0;
        image.texel(2, 5, 9)[channel] = odd;
        for (std::size_t i = channel; i < image.texels.size(); i += 4)
            if (std::isfinite(image.texels[i])) largest = std::max(largest, image.texels[i]);
        expected.texel(2, 5, 9)[channel] = becomes == INFINITE ? largest : becomes;
        const host::Image broken = image;
        const auto counts = host::sanitise(image);
        found.holds(bool(counts) && (*counts).*counter == 1, "is counted");
        found.holds(image.texels == expected.texels, "all other texels keep their bytes");
        // Light that no file reader has looked at: other channels are as they were.
        const Directions asked = axes(8, 26);
        const test::Prefiltered maps = bench.maps(broken, {{1, 64}});
        for (std::size_t map = 0; map < 2; ++map)
            found.sound(colours(bench.read(maps, map, asked)));
    }
}

void plus_infinity(Bench& bench, Findings& found) {
    sanitised(bench, found, INFINITE, INFINITE, &host::Sanitised::infinite);
}
void minus_infinity(Bench& bench, Findings& found) {
    sanitised(bench, found, -INFINITE, 0, &host::Sanitised::infinite);
}
void not_numbers(Bench& bench, Findings& found) {
    for (float odd : {NOT_A_NUMBER, std::numeric_limits<float>::signaling_NaN()})
        sanitised(bench, found, odd, 0, &host::Sanitised::not_a_number);
    found.at("channels apart");
    const Source source = oracle::random_panorama(Scene::noise, 17, 9, 27);
    host::Image broken = image_of(source);
    for (std::size_t i = 0; i < broken.texels.size(); i += 4) broken.texels[i] = NOT_A_NUMBER;
    const Directions asked = axes(8, 28);
    const auto before = bench.exact(source, 16, asked), after = bench.exact(broken, 16, asked);
    bool same = true;
    for (std::size_t i = 0; i < asked.size(); ++i)
        same = same && before[i][1] == after[i][1] && before[i][2] == after[i][2];
    found.holds(same, "red that is NaN everywhere leaves green and blue their bits");
}

void no_finite_texel(Bench&, Findings& found) {
    for (float odd : {NOT_A_NUMBER, INFINITE, -INFINITE}) {
        found.at("all " + text(odd));
        host::Image image = even_panorama(4, 2, odd, odd, odd);
        found.refused(host::sanitise(image), "no finite texel");
    }
}

void negative_texel(Bench& bench, Findings& found) {
    for (float odd : {-1e-30f, -1.0f, -FLT_MAX})
        sanitised(bench, found, odd, 0, &host::Sanitised::negative);
}

void denormal_light(Bench& bench, Findings& found) {
    const Directions asked = axes(12, 29);
    for (float light : {1e-42f, FLT_TRUE_MIN, FLT_MIN / 2}) {
        found.at(text(light));
        for (const Average& average : bench.exact(even_cube(8, light, light, light), 16, asked))
            found.within(std::abs(double(average[0]) - double(light)), double(FLT_MIN));
        const test::Prefiltered maps = bench.maps(even_cube(16, light, light, light), {{16}});
        const std::vector<Average> averages = bench.read(maps, 0, asked);
        found.sound(colours(averages));
        for (const Average& average : averages)
            found.within(std::abs(double(average[0]) - double(light)), double(FLT_MIN));
    }
}

void all_black(Bench& bench, Findings& found) {
    const Directions asked = axes(12, 30);
    const auto black = [](const std::vector<Average>& averages) {
        const std::vector<float> values = colours(averages);
        return values == std::vector<float>(values.size(), 0.0f);
    };
    const host::Image cube = even_cube(16, 0, 0, 0);
    for (float n : {0.0f, 1.0f, 4.8f, 64.0f, 1e4f}) {
        found.at("n " + text(n));
        found.holds(black(bench.exact(cube, n, asked)), "exact");
        found.holds(black(bench.read(bench.maps(cube, {{n}}), 0, asked)), "map");
    }
}

// What a map takes light for at most, so that no sum of it overflows.
constexpr double MOST = 0x1p120;

void even_light(Bench& bench, Findings& found, std::initializer_list<float> lights) {
    const Directions asked = axes(10, 31);
    for (float light : lights) {
        found.at(text(light));
        const host::Image panorama = even_panorama(17, 9, light, light, light);
        const host::Image cube = bench.cube(panorama, 16);
        found.holds(cube.texels == even_cube(16, light, light, light).texels,
                    "the cube map has the panorama's bytes");
        for (float n : {1.0f, 64.0f})
            for (const Average& average : bench.exact(panorama, n, asked))
                found.near(double(average[0]), double(light), SUMMATION);
        const test::Prefiltered maps = bench.maps(cube, {{0.5f, 700}});
        for (std::size_t map = 0; map < 2; ++map) {
            const std::vector<Average> averages = bench.read(maps, map, asked);
            found.sound(colours(averages));
            for (const Average& average : averages)
                found.near(double(average[0]), std::min(double(light), MOST), HALF + 1e-5);
        }
    }
}

void constants(Bench& bench, Findings& found) {
    even_light(bench, found, {1e-30f, 1e-8f, 0.18f, 1.0f, 1e8f, 65504.0f, FLT_MAX / 2});
}
void largest_light(Bench& bench, Findings& found) {
    even_light(bench, found, {FLT_MAX});
}

// A flat Radiance picture of one colour, 2 x 1.
std::string rgbe(unsigned char mantissa, unsigned char exponent) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    for (int i = 0; i < 2; ++i) {
        bytes.append(3, char(mantissa));
        bytes.push_back(char(exponent));
    }
    return bytes;
}

void shared_exponents(Bench& bench, Findings& found) {
    const test::TemporaryFolder folder;
    struct Texel {
        int mantissa, exponent;
    };
    for (const Texel& texel :
         {Texel{255, 255}, {2, 255}, {255, 1}, {128, 1}, {255, 0}, {0, 0}, {128, 129}}) {
        found.at("mantissa " + std::to_string(texel.mantissa) + ", exponent " +
                 std::to_string(texel.exponent));
        test::write_bytes(folder / "a.hdr", rgbe(static_cast<unsigned char>(texel.mantissa),
                                                 static_cast<unsigned char>(texel.exponent)));
        const host::Environment environment = value_of(host::read_environment(folder / "a.hdr"));
        const double truth =
            texel.exponent ? std::ldexp(texel.mantissa, texel.exponent - 136) : 0.0;
        found.sound(environment.image.texels);
        found.holds(environment.image.texels[0] == float(truth), "the value that the bytes mean");
        for (const Average& average : bench.exact(environment.image, 16, axes(4, 39)))
            found.within(std::abs(double(average[0]) - truth), SUMMATION * truth + double(FLT_MIN));
    }
}

void alpha(Bench& bench, Findings& found) {
    const host::Image image = image_of(oracle::random_panorama(Scene::suns, 32, 16, 40));
    const host::Image cube = bench.cube(image, 16);
    const Directions asked = axes(8, 41);
    const auto exact = bench.exact(image, 16, asked);
    const auto stored = bench.stored(bench.maps(cube, {{16}}), 0).texels;
    for (float a : {0.0f, 0.5f, NOT_A_NUMBER, INFINITE, -1.0f}) {
        found.at("alpha " + text(a));
        host::Image other = image, other_cube = cube;
        for (std::size_t i = 3; i < other.texels.size(); i += 4) other.texels[i] = a;
        for (std::size_t i = 3; i < other_cube.texels.size(); i += 4) other_cube.texels[i] = a;
        const host::Image made = bench.cube(other, 16);
        found.holds(made.texels == cube.texels, "the cube map has the same bytes");
        found.holds(bench.exact(other, 16, asked) == exact, "so have exact averages");
        found.holds(bench.stored(bench.maps(other_cube, {{16}}), 0).texels == stored,
                    "so have maps");
    }
}

} // namespace

Kind texel_values() {
    return {
        "Values of texels",
        {
            {"B05", "a texel of +infinity",
             "becomes the channel's largest finite value and is counted; others keep their bytes",
             plus_infinity},
            {"B06", "a texel of -infinity", "becomes 0 and is counted", minus_infinity},
            {"B07", "a texel of NaN, quiet or signalling; a channel of NaN",
             "becomes 0 and is counted; a channel spoils no other", not_numbers},
            {"B08", "no finite texel", "refused", no_finite_texel},
            {"B09", "a negative texel", "becomes 0 and is counted", negative_texel},
            {"B10", "denormal light", "off by the least normal number at most", denormal_light},
            {"B11", "all black", "exactly black", all_black},
            {"B12", "constant light from 1e-30 to half the largest float",
             "stays: exact to its sums, cube maps to the bit, maps to a half and up to 2^120",
             constants},
            {"B13", "the largest float everywhere", "the same, finite", largest_light},
            {"B21", "Radiance texels of exponents 0, 1 and 255", "the value that the bytes mean",
             shared_exponents},
            {"B22", "alpha 0, 0.5, NaN, infinite, negative", "means nothing: the same bytes",
             alpha},
        }};
}

} // namespace lobelia::hard
