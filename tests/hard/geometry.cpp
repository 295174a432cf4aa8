#include <algorithm>
#include <cmath>

#include "bench.h"
#include "catalogue.h"
#include "gpu/panorama_fixture.h"
#include "host/directions.h"
#include "support/oracle.h"

// E: the geometry of cube maps and the sphere.
namespace lobelia::hard {
namespace {

constexpr int GRID = 32; // directions along a face's side

// The largest step between neighbouring directions, relative to the brighter of the two.
double step_between(const std::vector<Average>& averages) {
    double most = 0;
    for (std::size_t i = 0; i + 1 < averages.size(); i += 2)
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = double(averages[i][c]), b = double(averages[i + 1][c]);
            most = std::max(most, std::abs(a - b) / std::max(a, b));
        }
    return most;
}

// Pairs of directions a grid's step apart: across all sides of all faces, and beside them.
struct Pairs {
    Directions across, beside;
};
Pairs pairs_at_edges() {
    Pairs pairs;
    const auto add = [](Directions& to, int face, double x0, double y0, double x1, double y1) {
        to.push_back(oracle::cube_direction(face, x0, y0, GRID));
        to.push_back(oracle::cube_direction(face, x1, y1, GRID));
    };
    for (int face = 0; face < 6; ++face)
        for (double along = 0.5; along < GRID; along += 1)
            for (double side : {0.0, double(GRID)}) {
                const double in = side == 0 ? 1 : -1;
                const double out = side - 0.5 * in;
                add(pairs.across, face, out, along, out + in, along);
                add(pairs.across, face, along, out, along, out + in);
                for (int step : {1, 2}) {
                    const double from = out + step * in;
                    add(pairs.beside, face, from, along, from + in, along);
                    add(pairs.beside, face, along, from, along, from + in);
                }
            }
    return pairs;
}

void edges(Bench& bench, Findings& found) {
    const Pairs pairs = pairs_at_edges();
    const host::Image source = image_of(oracle::random_cube(Scene::noise, 64, 51));
    const test::Prefiltered maps = bench.maps(source, {{0.5f, 4.8f, 45, 300}, true});
    for (std::size_t map = 0; map < maps.maps.size(); ++map) {
        found.at("n " + text(maps.plan.maps()[map].exponent) + ", map " + std::to_string(map));
        const double across = step_between(bench.read(maps, map, pairs.across));
        const double beside = step_between(bench.read(maps, map, pairs.beside));
        found.within(across / beside, 1.5);
    }
}

void corners(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::noise, 64, 52));
    const test::Prefiltered maps = bench.maps(source, {{0.5f, 4.8f, 45, 700}, true});
    for (std::size_t map = 0; map < maps.maps.size(); ++map) {
        found.at("n " + text(maps.plan.maps()[map].exponent) + ", map " + std::to_string(map));
        // Just beside each corner on its three faces, and a texel away from it there.
        Directions asked;
        for (double away : {1e-6, 2.0 / double(maps.plan.maps()[map].size)})
            for (int corner = 0; corner < 8; ++corner) {
                const double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1,
                             z = corner & 4 ? 1 : -1, less = 1 - away;
                for (const Direction& d : {Direction{x, y * less, z * less},
                                           {x * less, y, z * less},
                                           {x * less, y * less, z}})
                    asked.push_back(oracle::normalised(d));
            }
        const std::vector<Average> averages = bench.read(maps, map, asked);
        const bool spline = maps.plan.maps()[map].filter == MapFilter::spline;
        for (std::size_t i = 0; i < 24; i += 3)
            for (std::size_t c = 0; c < 3; ++c) {
                const double here = double(averages[i][c]);
                double step = 0;
                for (std::size_t k = i; k < i + 3; ++k)
                    step = std::max(step, std::abs(double(averages[24 + k][c]) / here - 1));
                for (std::size_t k : {i + 1, i + 2})
                    found.near(double(averages[k][c]), here, (spline ? step : 0) + 4 * HALF);
            }
    }
}

// Axes close to the poles and the middles of the faces there.
void poles(Bench& bench, Findings& found) {
    const Source panorama = oracle::random_panorama(Scene::smooth, 64, 32, 53);
    const host::Image cube = bench.cube(image_of(panorama), 64);
    Directions asked;
    for (double pole : {1.0, -1.0})
        for (double away : {0.0, 1e-7, 1e-5, 1e-3, 0.02})
            for (double turn : {0.0, 2.0, 4.0}) {
                const Direction d =
                    oracle::normalised({away * std::sin(turn), pole, away * std::cos(turn)});
                asked.push_back({float(d.x), float(d.y), float(d.z)});
            }
    const test::Prefiltered maps = bench.maps(cube, {{4.8f, 64}});
    for (std::size_t map = 0; map < 2; ++map) {
        const float n = maps.plan.maps()[map].exponent;
        found.at("n " + text(n));
        const std::vector<Average> exact = bench.exact(panorama, n, asked);
        const std::vector<Average> read = bench.read(maps, map, asked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Rgb truth = lobe_average(panorama, oracle::normalised(asked[i]), double(n));
            for (std::size_t c = 0; c < 3; ++c) {
                found.exact(double(exact[i][c]), truth[c], 2, double(n));
                found.near(double(read[i][c]), truth[c], 1e-2);
            }
        }
    }
}

bool is_corner(Direction d) {
    return std::abs(d.x) == std::abs(d.y) && std::abs(d.y) == std::abs(d.z);
}

void ties(Bench& bench, Findings& found) {
    Directions asked;
    for (double x : {-1.0, -0.0, 0.0, 1.0})
        for (double y : {-0.0, 0.0, 1.0})
            for (double z : {-1.0, -0.0})
                if (x != 0 || y != 0 || z != 0) {
                    const Direction d = oracle::normalised({x, y, z});
                    asked.push_back({float(d.x), float(d.y), float(d.z)});
                }
    oracle::Random random(54);
    Directions beside;
    for (const Direction& d : asked)
        beside.push_back(oracle::normalised(d + 1e-6 * random.direction()));
    const Source source = oracle::random_cube(Scene::noise, 16, 55);
    const test::Prefiltered maps = bench.maps(image_of(source), {{1, 64}});
    for (std::size_t map = 0; map < 2; ++map) {
        const float n = maps.plan.maps()[map].exponent;
        found.at("n " + text(n));
        struct Side {
            std::vector<Average> here, there;
            double allowed;
        };
        // Splines of two faces differ where the faces meet: E02.
        const double seam = maps.plan.maps()[map].filter == MapFilter::spline ? 1e-2 : 1e-3;
        for (const auto& [here, there, allowed] :
             {Side{bench.exact(source, n, asked), bench.exact(source, n, beside), 1e-3},
              Side{bench.read(maps, map, asked), bench.read(maps, map, beside), seam}}) {
            found.sound(colours(here));
            for (std::size_t i = 0; i < asked.size(); ++i) {
                if (!is_corner(asked[i]))
                    found.near(double(there[i][0]), double(here[i][0]), allowed);
                // Zeros of either sign are one direction.
                const auto same = std::find_if(asked.begin(), asked.end(), [&](Direction d) {
                    return d.x == asked[i].x && d.y == asked[i].y && d.z == asked[i].z;
                });
                found.holds(here[std::size_t(same - asked.begin())] == here[i],
                            "-0 is 0 in a direction");
            }
        }
    }
}

void orientation(Bench& bench, Findings& found) {
    // Each quarter of each face in a colour of its own, nothing symmetric.
    constexpr int SIZE = 16;
    const auto colour = [](int face, int x, int y) {
        return Rgb{double(face + 1), x < SIZE / 2 ? 1.0 : 5.0, y < SIZE / 2 ? 1.0 : 9.0};
    };
    Source source = oracle::cube_of(SIZE, [](Direction) { return Rgb{}; });
    Directions asked;
    std::vector<Rgb> expected;
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < SIZE; ++y)
            for (int x = 0; x < SIZE; ++x) {
                source.texel(face, x, y) = colour(face, x, y);
                if (x % 8 != 4 || y % 8 != 4) continue;
                asked.push_back(oracle::cube_direction(face, x, y, SIZE));
                expected.push_back(colour(face, x, y));
            }
    const auto same = [&](const std::vector<Average>& averages, double allowed) {
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                found.near(double(averages[i][c]), expected[i][c], allowed);
    };
    found.at("exact");
    same(bench.exact(source, 1e4f, asked), SUMMATION);
    found.at("map");
    same(bench.read(bench.maps(image_of(source), {{1e4f}}), 0, asked), 2 * HALF);
    // As a panorama: the middles of its texels say where they look.
    found.at("panorama to cube");
    const host::Image cube =
        bench.cube(image_of(oracle::panorama_of(256, 128,
                                                [](Direction d) {
                                                    return Rgb{2 + d.x, 2 + d.y, 2 + d.z};
                                                })),
                   16);
    const Directions middles = test::texel_directions(16);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        const double truth[] = {2 + middles[i].x, 2 + middles[i].y, 2 + middles[i].z};
        // A texel's mean is off its middle by h^2 / 12 times the curvature, at most 1, with
        // h = 2 / 16, and a panorama's step that it cuts by an eighth of that step.
        for (std::size_t c = 0; c < 3; ++c)
            found.within(std::abs(double(cube.texels[4 * i + c]) - truth[c]),
                         1.0 / 64 / 12 * 2 + 2 * oracle::PI / 256 / 8);
    }
}

void solid_angles_of_texels(Bench&, Findings& found) {
    for (std::uint32_t size : {1u, 2u, 3u, 8u, 17u, 128u, 512u, 1023u}) {
        found.at("faces of " + std::to_string(size));
        const std::vector<double> angles = host::solid_angles(size);
        double sum = 0;
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                const double angle = angles[std::size_t(y) * size + x];
                sum += 6 * angle;
                if (size <= 17)
                    found.near(angle, oracle::cube_texel_solid_angle(int(x), int(y), int(size)),
                               1e-11);
            }
        found.near(sum, 4 * oracle::PI, 1e-9);
    }
}

// A rotation by its columns.
struct Turn {
    Direction x, y, z;
    Direction operator()(Direction d) const { return d.x * x + d.y * y + d.z * z; }
};
Turn random_turn(oracle::Random& random) {
    const Direction x = random.direction();
    const Direction y = oracle::normalised(cross(x, random.direction()));
    return {x, y, cross(x, y)};
}

void any_rotation(Bench& bench, Findings& found) {
    const auto light = [](Direction d) {
        return Rgb{1 + 0.5 * d.x * d.y, 1 + 0.4 * d.z * d.z * d.x, 1.2 + d.y};
    };
    oracle::Random random(56);
    const Directions asked = axes(30, 57);
    const test::Prefiltered straight = bench.maps(image_of(oracle::cube_of(64, light)), {{1, 64}});
    for (int i = 0; i < 5; ++i) {
        const Turn turn = random_turn(random);
        const Source turned = oracle::cube_of(64, [&](Direction d) { return light(turn(d)); });
        Directions there;
        for (const Direction& d : asked) there.push_back(turn(d));
        const test::Prefiltered maps = bench.maps(image_of(turned), {{1, 64}});
        for (std::size_t map = 0; map < 2; ++map) {
            found.at("rotation " + std::to_string(i) + ", map " + std::to_string(map));
            const auto a = bench.read(maps, map, asked), b = bench.read(straight, map, there);
            double difference = 0, whole = 0;
            for (std::size_t k = 0; k < asked.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) {
                    difference += std::pow(double(a[k][c]) - double(b[k][c]), 2);
                    whole += std::pow(double(b[k][c]), 2);
                }
            found.within(std::sqrt(difference / whole), 1e-2);
        }
    }
}

void odd_faces(Bench& bench, Findings& found) {
    const Directions asked = axes(12, 58);
    for (std::uint32_t face : {1u, 2u, 3u, 255u}) {
        found.at("faces of " + std::to_string(face));
        for (const Average& average : bench.exact(even_cube(face, 1, 2, 3), 16, asked))
            for (std::size_t c = 0; c < 3; ++c)
                found.near(double(average[c]), double(c + 1), SUMMATION);
        const host::Image cube = bench.cube(even_panorama(6, 3, 1, 2, 3), face);
        found.holds(cube.texels == even_cube(face, 1, 2, 3).texels, "cube map");
    }
    // The prefilter's own sizes are powers of two; the host makes one of them of any.
    found.at("a map of faces of 3");
    const auto environment = value_of(host::upload_environment(bench.gpu(), even_cube(3, 1, 2, 3)));
    const auto made =
        value_of(host::prefilter(bench.gpu(), environment, {.exponents = {4.8f, 300}, .width = 5}));
    for (const host::Image& map : made.maps)
        for (std::size_t i = 0; i < map.texels.size(); ++i)
            if (i % 4 != 3) found.near(double(map.texels[i]), double(i % 4 + 1), HALF + 1e-5);
}

void far_sizes(Bench& bench, Findings& found) {
    const auto kept = [&](std::uint32_t width, std::uint32_t height, std::uint32_t face) {
        found.at(std::to_string(width) + " x " + std::to_string(height) + " to " +
                 std::to_string(face));
        const host::Image panorama = test::noise({width, height}, width + face);
        const host::Image cube = bench.cube(panorama, face);
        const Rgb before = test::mean(panorama), after = test::mean(cube);
        for (std::size_t c = 0; c < 3; ++c) found.near(after[c], before[c], 1e-4);
    };
    kept(8, 4, 512);
    kept(512, 256, 8);
    kept(512, 256, 1);
    kept(1023, 511, 33);
    kept(1, 1, 64);
}

void steps_within_a_texel(Bench& bench, Findings& found) {
    // Along a row of the diffuse map: between two middles what is read is a straight line, but for
    // the eight bits that hardware may give the weights.
    const host::Image source = image_of(oracle::random_cube(Scene::noise, 64, 59));
    const test::Prefiltered maps = bench.maps(source, {{}, true});
    const int size = int(maps.plan.maps()[0].size);
    for (int face = 0; face < 6; ++face) {
        found.at("face " + std::to_string(face));
        const double x = size / 2 - 2.5, y = size / 2 + 0.5;
        Directions asked;
        for (int i = 0; i <= 64; ++i)
            asked.push_back(oracle::cube_direction(face, x + i / 64.0, y, size));
        const std::vector<Average> averages = bench.read(maps, 0, asked);
        const double from = double(averages.front()[0]), to = double(averages.back()[0]);
        for (int i = 0; i <= 64; ++i)
            found.within(
                std::abs(double(averages[std::size_t(i)][0]) - from - i / 64.0 * (to - from)),
                std::abs(to - from) / 256 + 1e-5 * from);
    }
}

void sharpest_lobe(Bench& bench, Findings& found) {
    // A level that is too small or too blurred would give its mean, which is 10 % and more away.
    const Source source = oracle::random_cube(Scene::smooth, 128, 60);
    const test::Prefiltered maps = bench.maps(image_of(source), {{1e4f, 1e6f}});
    Directions asked;
    std::vector<Rgb> mirrored;
    for (int i = 0; i < 100; ++i) {
        const int face = i % 6, x = (i * 37) % 128, y = (i * 11) % 128;
        asked.push_back(source.direction(face, x, y));
        mirrored.push_back(source.texel(face, x, y));
    }
    for (std::size_t map = 0; map < 2; ++map) {
        found.at("n " + text(maps.plan.maps()[map].exponent));
        const std::vector<Average> averages = bench.read(maps, map, asked);
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                found.within(std::abs(double(averages[i][c]) - mirrored[i][c]), 1e-2);
    }
}

} // namespace

Kind geometry() {
    return {
        "Geometry of cube maps and the sphere",
        {
            {"E01", "the 12 edges", "no step larger than 1.5 times those beside it", edges},
            {"E02", "the 8 corners, from their three faces",
             "the same value to four halves; where a spline reads the map, less than the step to "
             "the "
             "next texel apart",
             corners},
            {"E03", "poles and the middles of the faces there",
             "exact is the integral; the map is within 1e-2", poles},
            {"E04", "axes, diagonals of faces and of the cube, with zeros of either sign",
             "finite, continuous to 1e-3, to 1e-2 where splines of two faces meet; -0 is 0 to the "
             "bit",
             ties},
            {"E05", "faces whose quarters differ", "nothing is mirrored or turned", orientation},
            {"E06", "solid angles of texels, faces of 1 to 1023", "add up to the sphere",
             solid_angles_of_texels},
            {"E07", "the 24 rotations of the cube, with suns", "turn the maps, to the half beside",
             nullptr, "PrefilterRotationTest.TurnsWithItsSuns"},
            {"E08", "rotations of any angle", "turn the maps: 1e-2 of the whole", any_rotation},
            {"E09", "faces of 1, 2, 3, 255 texels", "constant light stays", odd_faces},
            {"E10", "8 x 4 to faces of 512, 512 x 256 to 8 and 1", "the mean is kept to 1e-4",
             far_sizes},
            {"E11", "steps smaller than a texel", "a straight line to a 256th of the step",
             steps_within_a_texel},
            {"E12", "the sharpest lobes", "show the mirror's image, not a mean: 1e-2",
             sharpest_lobe},
        }};
}

} // namespace lobelia::hard
