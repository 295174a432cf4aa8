#include <cmath>

#include "bench.h"
#include "catalogue.h"
#include "gpu/panorama_fixture.h"
#include "support/oracle.h"

// B01 to B04, B14 to B20: suns, and other light that stands out.
namespace lobelia::hard {
namespace {

Rgb grey(double value) {
    return {value, value, value};
}

// One texel of a cube map or panorama is `sun`, the others `sky`.
struct Place {
    const char* name;
    bool cube;
    int layer, x, y;
};
constexpr int SUN_FACE = 32; // and panoramas of 64 x 32
constexpr Place PLACES[] = {{"face's middle", true, 4, 16, 16},
                            {"edge", true, 4, 10, 0},
                            {"corner", true, 4, 0, 0},
                            {"pole of a panorama", false, 0, 20, 0},
                            {"seam of a panorama", false, 0, 0, 12}};

Source with_sun(const Place& place, const Rgb& sky, const Rgb& sun) {
    const auto even = [&](Direction) { return sky; };
    Source source =
        place.cube ? oracle::cube_of(SUN_FACE, even) : oracle::panorama_of(64, 32, even);
    source.texel(place.layer, place.x, place.y) = sun;
    return source;
}

// Near the sun and all over, but for those whose horizon cuts it: there the truth itself changes
// with the axis's last digit.
Directions axes_for(Direction sun, float n, std::uint64_t seed) {
    Directions asked{sun};
    oracle::Random random(seed);
    while (asked.size() < 10) {
        const double reach = asked.size() < 6 ? 3 / std::sqrt(double(n) + 1) : 2;
        const Direction d = oracle::normalised(sun + random.between(0, reach) * random.direction());
        if (std::abs(dot(d, sun)) > 0.15) asked.push_back(d);
    }
    for (Direction& d : asked) d = {float(d.x), float(d.y), float(d.z)};
    return asked;
}

void sun(Bench& bench, Findings& found, double radiance, std::initializer_list<float> exponents) {
    const Rgb light{radiance, radiance / 2, radiance / 8};
    for (const Place& place : PLACES)
        for (float n : exponents) {
            found.at(std::string(place.name) + ", n " + text(n));
            const Source source = with_sun(place, grey(0.1), light);
            const Directions asked =
                axes_for(source.direction(place.layer, place.x, place.y), n, 21);
            const std::vector<Average> averages = bench.exact(source, n, asked);
            found.sound(colours(averages));
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const Rgb truth = lobe_average(source, oracle::normalised(asked[i]), double(n));
                for (std::size_t c = 0; c < 3; ++c) {
                    found.exact(double(averages[i][c]), truth[c], light[c], double(n));
                    found.holds(double(averages[i][c]) <= light[c], "nothing outshines the sun");
                }
            }
        }
    // In a map a sun is a point with an extent: its texel is to be smaller than the lobe.
    constexpr int FINE = 256;
    for (const Place& place : PLACES) {
        if (!place.cube) continue;
        found.at(std::string(place.name) + ", maps");
        Source source = oracle::cube_of(FINE, [](Direction) { return grey(0.1); });
        const int x = place.x * FINE / SUN_FACE, y = place.y * FINE / SUN_FACE;
        source.texel(place.layer, x, y) = light;
        const test::Prefiltered maps = bench.maps(image_of(source), {{1, 30, 700}});
        for (std::size_t map = 0; map < 3; ++map) {
            const double n = double(maps.plan.maps()[map].exponent);
            const Directions asked = axes_for(source.direction(place.layer, x, y), float(n), 22);
            const std::vector<Average> averages = bench.read(maps, map, asked);
            found.sound(colours(averages));
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const Rgb truth = lobe_average(source, oracle::normalised(asked[i]), n);
                for (std::size_t c = 0; c < 3; ++c)
                    found.near(double(averages[i][c]), truth[c], 1e-2);
            }
        }
    }
}

void bright_sun(Bench& bench, Findings& found) {
    sun(bench, found, 1e5, {1.0f, 1e3f});
}
void brightest_sun(Bench& bench, Findings& found) {
    sun(bench, found, 1e9, {0.0f, 30.0f});
}

void ladder(Bench& bench, Findings& found) {
    // Texels that lie on either side of the largest half, then scaled by powers of two.
    Source source = oracle::random_cube(Scene::noise, 16, 23);
    const double values[] = {65504, 65519, 65520, 65536};
    for (int i = 0; i < 4; ++i) source.texel(i, 3 * i, 5) = grey(values[i]);
    const host::Image image = image_of(source);
    const Directions asked = axes(8, 24);
    const std::vector<Average> exact = bench.exact(image, 16, asked);
    const test::Prefiltered maps = bench.maps(image, {{16, 700}});
    const std::vector<float> stored = bench.stored(maps, 0).texels;
    const std::vector<float> sharp = bench.stored(maps, 1).texels;
    for (int power : {-30, -10, 1, 10, 20, 40}) {
        found.at("2^" + std::to_string(power));
        host::Image scaled = image;
        for (float& value : scaled.texels) value = std::ldexp(value, power);
        const std::vector<Average> more = bench.exact(scaled, 16, asked);
        bool same = true;
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                same = same && more[i][c] == std::ldexp(exact[i][c], power);
        found.holds(same, "exact averages scale to the bit");
        const test::Prefiltered others = bench.maps(scaled, {{16, 700}});
        found.holds(bench.stored(others, 0).texels == stored &&
                        bench.stored(others, 1).texels == sharp,
                    "maps keep their bytes beside the scale");
    }
    for (double value : values) {
        found.at("everywhere " + text(float(value)));
        const float light = float(value);
        const test::Prefiltered even = bench.maps(even_cube(16, light, light, light), {{64}});
        for (const Average& average : bench.read(even, 0, asked))
            found.near(double(average[0]), value, HALF + 1e-5);
    }
}

// Of a panorama made into faces of that size.
void mean_kept(Bench& bench, Findings& found, const host::Image& panorama, std::uint32_t face,
               double allowed = 1e-4) {
    const Rgb before = test::mean(panorama);
    const host::Image cube = bench.cube(panorama, face);
    found.sound(cube.texels);
    const Rgb after = test::mean(cube);
    for (std::size_t c = 0; c < 3; ++c)
        if (before[c] > 0) found.near(after[c], before[c], allowed);
}

void no_clamp(Bench& bench, Findings& found) {
    for (double radiance : {1e5, 1e9, 1e20})
        for (std::uint32_t face : {8u, 64u}) {
            found.at("sun " + text(float(radiance)) + ", faces of " + std::to_string(face));
            host::Image panorama = even_panorama(64, 32, 0.1f, 0.1f, 0.1f);
            const float colour[] = {float(radiance), float(radiance / 2), float(radiance / 5)};
            std::copy_n(colour, 3, panorama.texel(0, 40, 9));
            mean_kept(bench, found, panorama, face);
        }
}

void tail_of_the_sky(Bench& bench, Findings& found) {
    const Source source = with_sun(PLACES[0], grey(1e-8), grey(1e8));
    const double sky = double(1e-8f);
    Directions away;
    oracle::Random random(32);
    while (away.size() < 12) {
        const Direction d = random.direction();
        if (d.z < -0.1) away.push_back({float(d.x), float(d.y), float(d.z)});
    }
    const test::Prefiltered maps = bench.maps(image_of(source), {{1, 16, 1e3f}});
    for (std::size_t map = 0; map < 3; ++map) {
        const float n = maps.plan.maps()[map].exponent;
        found.at("n " + text(n));
        for (const Average& average : bench.exact(source, n, away))
            found.near(double(average[0]), sky, 1e-3);
        for (const Average& average : bench.read(maps, map, away))
            found.near(double(average[0]), sky, 1e-3);
    }
}

void checkerboard(Bench& bench, Findings& found) {
    for (auto [width, height] : {std::pair{64u, 32u}, {63u, 31u}, {17u, 9u}})
        for (std::uint32_t face : {8u, 15u, 64u}) {
            found.at(std::to_string(width) + " x " + std::to_string(height) + ", faces of " +
                     std::to_string(face));
            host::Image panorama = even_panorama(width, height, 0, 0, 0);
            for (std::uint32_t y = 0; y < height; ++y)
                for (std::uint32_t x = 0; x < width; ++x)
                    std::fill_n(panorama.texel(0, x, y), 3, (x + y) % 2 ? 1e6f : 0.0f);
            mean_kept(bench, found, panorama, face);
        }
}

void suns_of_one_channel(Bench& bench, Findings& found) {
    Source all = oracle::random_cube(Scene::noise, 16, 33);
    const Source sky = all;
    for (std::size_t c = 0; c < 3; ++c) all.texel(int(c), 4, int(5 * c))[c] = 1e9;
    const Directions asked = axes(10, 34);
    const host::Image image = image_of(all);
    for (float n : {1.0f, 64.0f}) {
        const std::vector<Average> together = bench.exact(image, n, asked);
        for (std::size_t c = 0; c < 3; ++c) {
            found.at("n " + text(n) + ", channel " + std::to_string(c));
            Source alone = sky;
            alone.texel(int(c), 4, int(5 * c))[c] = 1e9;
            const std::vector<Average> one = bench.exact(alone, n, asked);
            bool same = true;
            for (std::size_t i = 0; i < asked.size(); ++i)
                same = same && one[i][c] == together[i][c];
            found.holds(same, "a channel does not see the suns of the others");
        }
    }
}

void seam(Bench& bench, Findings& found) {
    constexpr int WIDTH = 64;
    Source source = oracle::random_panorama(Scene::noise, WIDTH, 32, 35);
    source.texel(0, WIDTH - 1, 12) = grey(1e6);
    source.texel(0, 0, 20) = grey(1e6);
    // A column later: longitudes fall as x grows, so everything turns by minus one column.
    Source turned = source;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < WIDTH; ++x) turned.texel(0, (x + 1) % WIDTH, y) = source.texel(0, x, y);
    const double angle = -2 * oracle::PI / WIDTH;
    for (float n : {1.0f, 16.0f, 300.0f}) {
        found.at("n " + text(n));
        Directions asked, there;
        for (const Direction& d : axes(14, 36)) {
            if (std::abs(dot(d, source.direction(0, WIDTH - 1, 12))) < 0.1 ||
                std::abs(dot(d, source.direction(0, 0, 20))) < 0.1)
                continue;
            asked.push_back(d);
            there.push_back({d.x * std::cos(angle) + d.z * std::sin(angle), d.y,
                             d.z * std::cos(angle) - d.x * std::sin(angle)});
        }
        const std::vector<Average> before = bench.exact(source, n, asked);
        const std::vector<Average> after = bench.exact(turned, n, there);
        // An axis of 32 bits is off by 6e-8, a lobe's slope at most 2 sqrt(n) of itself near its
        // axis and n elsewhere.
        for (std::size_t i = 0; i < asked.size(); ++i)
            found.near(double(after[i][0]), double(before[i][0]), 2 * SUMMATION + 6e-7 * double(n));
    }
}

void suns_at_the_poles(Bench& bench, Findings& found) {
    for (int row : {0, 31})
        for (float n : {64.0f, 1e3f}) {
            found.at("row " + std::to_string(row) + ", n " + text(n));
            Source source = oracle::panorama_of(64, 32, [](Direction) { return Rgb{}; });
            for (int x = 0; x < 64; ++x) source.texel(0, x, row) = grey(1e9);
            const double side = row == 0 ? -1 : 1;
            const Directions other{{0, side, 0}, {0.6, 0.8 * side, 0}, {0.1, 0.5 * side, -0.86}};
            const auto dark = [](const std::vector<Average>& averages) {
                const std::vector<float> values = colours(averages);
                return values == std::vector<float>(values.size(), 0.0f);
            };
            found.holds(dark(bench.exact(source, n, other)), "exact is 0");
            const host::Image cube = bench.cube(image_of(source), 32);
            found.holds(dark(bench.read(bench.maps(cube, {{n}}), 0, other)), "the map is 0");
        }
}

void uneven_pole(Bench& bench, Findings& found) {
    Source source = oracle::random_panorama(Scene::smooth, 64, 32, 37);
    for (int x = 0; x < 64; ++x) {
        source.texel(0, x, 0) = x % 2 ? Rgb{8, 4, 1} : Rgb{0, 0, 0};
        source.texel(0, x, 31) = x < 32 ? Rgb{2, 2, 2} : Rgb{0, 1, 0};
    }
    Directions asked{{0, 1, 0}, {0, -1, 0}};
    oracle::Random random(38);
    for (double y : {1.0, -1.0})
        for (int i = 0; i < 4; ++i) {
            const Direction d = oracle::normalised(Direction{0, y, 0} + 0.05 * random.direction());
            asked.push_back({float(d.x), float(d.y), float(d.z)});
        }
    for (float n : {1.0f, 64.0f, 1e3f}) {
        found.at("n " + text(n));
        const std::vector<Average> averages = bench.exact(source, n, asked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Rgb truth = lobe_average(source, oracle::normalised(asked[i]), double(n));
            for (std::size_t c = 0; c < 3; ++c)
                found.exact(double(averages[i][c]), truth[c], 8, double(n));
        }
    }
    for (std::uint32_t face : {8u, 33u}) {
        found.at("faces of " + std::to_string(face));
        mean_kept(bench, found, image_of(source), face);
    }
}

void sun_within_a_texel(Bench& bench, Findings& found) {
    host::Image panorama = even_panorama(256, 128, 0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c)
        panorama.texel(0, std::uint32_t(50 * c + 7), std::uint32_t(40 * c + 3))[c] = 1e9f;
    for (std::uint32_t face : {8u, 16u, 32u, 64u, 128u, 256u, 512u}) {
        found.at("faces of " + std::to_string(face));
        mean_kept(bench, found, panorama, face);
    }
}

} // namespace

Kind suns() {
    return {"Suns and contrasts",
            {
                {"B01", "a sun of 1e5 in one texel: middle, edge, corner, pole, seam",
                 "exact is the integral; the map is within 1e-2 of it; none outshines the sun",
                 bright_sun},
                {"B02", "a sun of 1e9 there", "the same", brightest_sun},
                {"B03", "65504, 65519, 65520, 65536, and all times 2^-30 to 2^40",
                 "linear to the bit through the largest half", ladder},
                {"B04", "suns of 1e5 to 1e20 on the way into a cube map",
                 "no clamp: mean and hue are kept to 1e-4", no_clamp},
                {"B14", "a sky of 1e-8 with a texel of 1e8", "the far side is 1e-8 to 1e-3",
                 tail_of_the_sky},
                {"B15", "a checkerboard of 0 and 1e6, even and odd sizes",
                 "the mean is kept to 1e-4", checkerboard},
                {"B16", "a sun in each channel at another place",
                 "each channel has the bits that it has alone", suns_of_one_channel},
                {"B17", "suns on a panorama's first and last column",
                 "turning by a column turns the averages", seam},
                {"B18", "suns all along the top or bottom row", "exactly black at the other pole",
                 suns_at_the_poles},
                {"B19", "a pole's row that is not constant", "rows count by their solid angle",
                 uneven_pole},
                {"B20", "suns smaller than a face's texel, faces of 8 to 512",
                 "the mean is kept to 1e-4", sun_within_a_texel},
            }};
}

} // namespace lobelia::hard
