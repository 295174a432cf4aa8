#include <cmath>
#include <functional>

#include "bench.h"
#include "catalogue.h"
#include "support/harmonics.h"
#include "support/oracle.h"
#include "support/some_of.h"

// O: facts that hold for every environment, over random ones.
namespace lobelia::hard {
namespace {

constexpr int ENVIRONMENTS = 20 / test::ONE_IN; // of each fact

// A small environment of its own for each seed, of every kind and shape.
Source environment(std::uint64_t seed) {
    constexpr Scene SCENES[] = {Scene::smooth, Scene::noise, Scene::suns, Scene::halves};
    const Scene scene = SCENES[seed % 4];
    switch (seed / 4 % 3) {
    case 0: return oracle::random_panorama(scene, 17, 9, seed);
    case 1: return oracle::random_cube(scene, 5, seed);
    }
    return oracle::random_panorama(scene, 32, 16, seed);
}

using Look =
    std::function<void(std::uint64_t seed, const Source& source, float n, const Directions& asked)>;

// A point for each environment, an exponent for each; the seed is told with what fails.
void over_environments(Findings& found, const Look& look) {
    constexpr float EXPONENTS[] = {0, 1, 4.8f, 64, 1e3f};
    for (std::uint64_t seed = 1; seed <= ENVIRONMENTS; ++seed) {
        const float n = EXPONENTS[seed % 5];
        const Source source = environment(seed);
        found.at("seed " + std::to_string(seed) + ", n " + text(n) + ", " + test::shape_of(source));
        look(seed, source, n, axes(8, 1000 + seed));
    }
}

double difference(double found, double truth, double brightest) {
    return std::abs(found - truth) / std::max(truth, 1e-6 * brightest);
}

void constant_light(Bench& bench, Findings& found) {
    over_environments(
        found, [&](std::uint64_t seed, const Source& shape, float n, const Directions& asked) {
            Source source = shape;
            const double light = double(float(std::exp(oracle::Random(seed).between(-20, 20))));
            for (int layer = 0; layer < source.layers(); ++layer)
                for (int y = 0; y < source.height(); ++y)
                    for (int x = 0; x < source.width(); ++x)
                        source.texel(layer, x, y) = {light, light, light};
            for (const Average& average : bench.exact(source, n, asked))
                for (std::size_t c = 0; c < 3; ++c)
                    found.near(double(average[c]), light, SUMMATION);
        });
}

void linearity(Bench& bench, Findings& found) {
    over_environments(found, [&](std::uint64_t seed, const Source& first, float n,
                                 const Directions& asked) {
        Source second = first, both = first;
        oracle::Random random(seed);
        for (int layer = 0; layer < first.layers(); ++layer)
            for (int y = 0; y < first.height(); ++y)
                for (int x = 0; x < first.width(); ++x)
                    for (std::size_t c = 0; c < 3; ++c) {
                        second.texel(layer, x, y)[c] = double(float(random.between(0, 10)));
                        both.texel(layer, x, y)[c] =
                            3 * first.texel(layer, x, y)[c] + second.texel(layer, x, y)[c];
                    }
        const auto a = bench.exact(first, n, asked), b = bench.exact(second, n, asked),
                   sum = bench.exact(both, n, asked);
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                found.near(double(sum[i][c]), 3 * double(a[i][c]) + double(b[i][c]), 2 * SUMMATION);
    });
}

void maximum(Bench& bench, Findings& found) {
    over_environments(found,
                      [&](std::uint64_t, const Source& source, float n, const Directions& asked) {
                          Rgb least = source.texels()[0];
                          for (const Rgb& texel : source.texels())
                              for (std::size_t c = 0; c < 3; ++c)
                                  least[c] = std::min(least[c], texel[c]);
                          const Rgb most = test::largest(source);
                          const std::vector<Average> averages = bench.exact(source, n, asked);
                          found.sound(colours(averages));
                          for (const Average& average : averages)
                              for (std::size_t c = 0; c < 3; ++c) {
                                  found.within(double(average[c]) / most[c] - 1, SUMMATION);
                                  if (least[c] > 0)
                                      found.within(1 - double(average[c]) / least[c], SUMMATION);
                              }
                      });
}

void mean_of_averages(Bench& bench, Findings& found) {
    // The kernel is zonal and its integral is 1: over the sphere the averages have the light's
    // mean.
    constexpr int GRID = 32;
    const Directions grid = test::texel_directions(GRID);
    for (std::uint64_t seed = 1; seed <= ENVIRONMENTS; ++seed) {
        const float n = seed % 2 ? 1.0f : 16.0f;
        const Source source = oracle::random_cube(oracle::ALL_SCENES[seed % 4], 32, seed);
        found.at("seed " + std::to_string(seed) + ", n " + text(n));
        const test::Prefiltered maps = bench.maps(image_of(source), {{n}});
        const std::vector<Average> averages = bench.read(maps, 0, grid);
        Rgb mean{};
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const int x = int(i) % GRID, y = int(i) / GRID % GRID;
            for (std::size_t c = 0; c < 3; ++c)
                mean[c] += double(averages[i][c]) * oracle::cube_texel_solid_angle(x, y, GRID) /
                           (4 * oracle::PI);
        }
        for (std::size_t c = 0; c < 3; ++c) found.near(mean[c], source.mean()[c], 1e-3);
    }
}

void eigenvalues(Bench& bench, Findings& found) {
    constexpr int SIZE = 64;
    constexpr double SAMPLING = 0.5 * 3 * (2.0 / SIZE) * (2.0 / SIZE) / 24;
    oracle::Random random(7);
    for (int i = 0; i < ENVIRONMENTS; ++i) {
        const int l = 1 + random.below(4);
        const int m = random.below(2 * l + 1) - l;
        const float n = float(std::exp(random.between(-1, 5)));
        found.at("degree " + std::to_string(l) + ", order " + std::to_string(m) + ", n " + text(n));
        const Source source = oracle::cube_of(SIZE, [&](Direction d) {
            const double light = 1 + 0.5 * oracle::harmonic(l, m, d);
            return Rgb{light, light, light};
        });
        const Directions asked = axes(8, 1100 + std::uint64_t(i));
        const std::vector<Average> averages = bench.exact(source, n, asked);
        for (std::size_t k = 0; k < asked.size(); ++k)
            found.within(std::abs(double(averages[k][0]) - 1 -
                                  0.5 * oracle::lobe_eigenvalue(double(n), l) *
                                      oracle::harmonic(l, m, asked[k])),
                         SAMPLING * l * (l + 1) + SUMMATION);
    }
}

// Axis i of the result is `sign[i]` times axis `from[i]`; a rotation of the cube.
struct CubeTurn {
    int from[3];
    int sign[3];
    Direction operator()(Direction d) const {
        const double axes[] = {d.x, d.y, d.z};
        return {sign[0] * axes[from[0]], sign[1] * axes[from[1]], sign[2] * axes[from[2]]};
    }
};
constexpr CubeTurn TURNS[] = {{{0, 2, 1}, {1, 1, -1}},
                              {{1, 2, 0}, {1, 1, 1}},
                              {{2, 0, 1}, {1, -1, -1}},
                              {{0, 1, 2}, {-1, -1, 1}}};

void rotations(Bench& bench, Findings& found) {
    for (std::uint64_t seed = 1; seed <= ENVIRONMENTS; ++seed) {
        const float n = seed % 2 ? 4.8f : 64.0f;
        const CubeTurn& turn = TURNS[seed % 4];
        found.at("seed " + std::to_string(seed) + ", n " + text(n));
        const Source source = oracle::random_cube(oracle::ALL_SCENES[seed / 4 % 4], 5, seed);
        Source turned = source;
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < 5; ++y)
                for (int x = 0; x < 5; ++x) {
                    const oracle::FacePoint from =
                        oracle::cube_point(turn(source.direction(face, x, y)), 5);
                    turned.texel(face, x, y) = source.texel(from.face, int(from.x), int(from.y));
                }
        const Directions asked = axes(8, 1200 + seed);
        Directions there;
        for (const Direction& d : asked) there.push_back(turn(d));
        const auto a = bench.exact(turned, n, asked), b = bench.exact(source, n, there);
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                found.within(difference(double(a[i][c]), double(b[i][c]), test::largest(source)[c]),
                             1e-4);
    }
}

// Where a texel of a panorama of 64 x 32 lies on the average over its solid angle: near a pole that
// is not its middle.
Direction mean_direction(int x, int y) {
    constexpr int PARTS = 64;
    Direction sum{};
    for (int i = 0; i < PARTS; ++i)
        for (int j = 0; j < PARTS; ++j) {
            const double longitude = 2 * oracle::PI * (0.5 - (x + (i + 0.5) / PARTS) / 64);
            const double latitude = oracle::PI * (0.5 - (y + (j + 0.5) / PARTS) / 32);
            const double ring = std::cos(latitude);
            sum.x += std::sin(longitude) * ring * ring;
            sum.y += std::sin(latitude) * ring;
            sum.z += std::cos(longitude) * ring * ring;
        }
    const double length = std::sqrt(dot(sum, sum));
    return {sum.x / length, sum.y / length, sum.z / length};
}

void lone_texel(Bench& bench, Findings& found) {
    for (std::uint64_t seed = 1; seed <= ENVIRONMENTS; ++seed) {
        oracle::Random random(seed);
        const float n = seed % 2 ? 1.0f : 16.0f;
        Source source = oracle::panorama_of(64, 32, [](Direction) { return Rgb{}; });
        const int x = random.below(64), y = random.below(32);
        found.at("seed " + std::to_string(seed) + ", n " + text(n) + ", texel " +
                 std::to_string(x) + " " + std::to_string(y));
        source.texel(0, x, y) = {1, 1e9, 1e-9};
        const Direction sun = mean_direction(x, y);
        const double angle = source.solid_angle(x, y);
        Directions asked;
        while (asked.size() < 6) {
            const Direction d = random.direction();
            if (std::abs(dot(d, sun)) > 0.3) asked.push_back({float(d.x), float(d.y), float(d.z)});
        }
        const std::vector<Average> averages = bench.exact(source, n, asked);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const double cosine = dot(asked[i], sun);
            if (cosine < 0) {
                found.holds(averages[i][1] == 0, "nothing behind");
                continue;
            }
            const double truth =
                (double(n) + 1) / (2 * oracle::PI) * 1e9 * angle * std::pow(cosine, double(n));
            // The texel's sides are at most h = pi / 32: off by h^2 / 24 times the lobe's curvature
            // along both, at most n (n - 1) tan^2 + n each.
            const double tangent = std::sqrt(1 - cosine * cosine) / cosine;
            const double curvature =
                double(n) * (std::abs(double(n) - 1) * tangent * tangent + 1) + 2;
            found.near(double(averages[i][1]), truth,
                       2 * std::pow(oracle::PI / 32, 2) / 24 * curvature);
            found.holds(double(averages[i][1]) <= 1e9, "no brighter than the sun");
        }
    }
}

void mirror(Bench& bench, Findings& found) {
    for (std::uint64_t seed = 1; seed <= ENVIRONMENTS; ++seed) {
        found.at("seed " + std::to_string(seed));
        const Source source = oracle::random_cube(oracle::ALL_SCENES[seed % 4], 8, seed);
        oracle::Random random(seed);
        Directions asked;
        std::vector<Rgb> seen;
        for (int i = 0; i < 4; ++i) {
            const int face = random.below(6), x = random.below(8), y = random.below(8);
            asked.push_back(source.direction(face, x, y));
            seen.push_back(source.texel(face, x, y));
        }
        const std::vector<Average> averages = bench.exact(source, 1e5f, asked);
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                found.within(
                    difference(double(averages[i][c]), seen[i][c], test::largest(source)[c]),
                    SUMMATION);
    }
}

void half_sphere(Bench& bench, Findings& found) {
    const auto front = [](Direction d) { return d.z > 0 ? Rgb{1, 1, 1} : Rgb{}; };
    const Source sources[] = {oracle::panorama_of(64, 32, front), oracle::cube_of(16, front)};
    oracle::Random random(8);
    for (int i = 0; i < ENVIRONMENTS; ++i) {
        const float n = i == 0 ? 0 : float(std::exp(random.between(-3, 9)));
        const double turn = random.between(0, 6);
        found.at("n " + text(n));
        const auto averages =
            bench.exact(sources[i % 2], n,
                        {{0, 0, 1}, {0, 0, -1}, {float(std::sin(turn)), float(std::cos(turn)), 0}});
        found.within(std::abs(double(averages[0][0]) - 1), 1e-6);
        found.within(double(averages[1][0]), 1e-6);
        found.within(std::abs(double(averages[2][0]) - 0.5), SUMMATION);
    }
}

void hemisphere_mean(Bench& bench, Findings& found) {
    over_environments(
        found, [&](std::uint64_t, const Source& source, float, const Directions& asked) {
            const Rgb mean = source.mean();
            Directions both = asked;
            for (const Direction& d : asked) both.push_back(-1.0 * d);
            const std::vector<Average> averages = bench.exact(source, 0, both);
            for (std::size_t i = 0; i < asked.size(); ++i)
                for (std::size_t c = 0; c < 3; ++c) // a half sphere and the other are the sphere
                    found.near(double(averages[i][c]) + double(averages[asked.size() + i][c]),
                               2 * mean[c], 1e-5);
        });
}

void scaling(Bench& bench, Findings& found) {
    over_environments(found, [&](std::uint64_t seed, const Source& source, float n,
                                 const Directions& asked) {
        const int power = int(seed % 2 ? seed : 0 - seed);
        host::Image scaled = image_of(source);
        for (float& value : scaled.texels) value = std::ldexp(value, power);
        const auto before = bench.exact(source, n, asked), after = bench.exact(scaled, n, asked);
        bool same = true;
        for (std::size_t i = 0; i < asked.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                same = same && after[i][c] == std::ldexp(before[i][c], power);
        found.holds(same, "times 2^" + std::to_string(power) + " to the bit");
    });
}

void channels(Bench& bench, Findings& found) {
    over_environments(
        found, [&](std::uint64_t, const Source& source, float n, const Directions& asked) {
            host::Image other = image_of(source);
            for (std::size_t i = 0; i < other.texels.size(); i += 4)
                std::swap(other.texels[i], other.texels[i + 2]);
            const auto before = bench.exact(source, n, asked), after = bench.exact(other, n, asked);
            bool same = true;
            for (std::size_t i = 0; i < asked.size(); ++i)
                same = same && after[i][0] == before[i][2] && after[i][1] == before[i][1] &&
                       after[i][2] == before[i][0];
            found.holds(same, "red and blue swapped swap red and blue");
        });
}

void twice(Bench& bench, Findings& found) {
    over_environments(
        found, [&](std::uint64_t, const Source& source, float n, const Directions& asked) {
            found.holds(bench.exact(source, n, asked) == bench.exact(source, n, asked),
                        "the same bytes");
        });
}

void white_sphere(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, 16, 12);
    oracle::Random random(9);
    for (int i = 0; i < ENVIRONMENTS; ++i) {
        const float kd = float(random.unit()), ks = 1 - kd;
        const float n = float(std::exp(random.between(-2, 13)));
        const SphereView view{.camera = test::random_camera(random),
                              .material = test::grey(kd, ks, n),
                              .width = 16,
                              .height = 12};
        found.at(test::text(view.camera) + " n " + text(n));
        const host::Image picture = sphere.draw(view);
        found.sound(picture.texels);
        const oracle::Camera camera = test::oracle_camera(view);
        for (std::uint32_t y = 0; y < view.height; ++y)
            for (std::uint32_t x = 0; x < view.width; ++x) {
                const auto hit = oracle::meet_sphere(camera.eye, ray(camera, x + 0.5, y + 0.5));
                const float* pixel = picture.texel(0, x, y);
                if (!hit || pixel[3] < 1) continue;
                const double cosine = dot(hit->normal, hit->view);
                found.within(std::abs(double(pixel[0]) - double(kd) -
                                      double(ks) * oracle::albedo(cosine, double(n))),
                             test::furnace_tolerance(cosine, 1));
            }
    }
}

void reciprocity(Bench&, Findings& found) {
    oracle::Random random(10);
    for (int i = 0; i < ENVIRONMENTS; ++i) {
        const Direction normal = random.direction();
        const Direction in = random.direction_above(normal), out = random.direction_above(normal);
        const float n = float(std::exp(random.between(-2, 8)));
        found.at("pair " + std::to_string(i) + ", n " + text(n));
        const auto brdf = [&](Direction from, Direction to) {
            const Direction apart = oracle::mirror(normal, to) - from;
            return double(phong_brdf(0.3f, 0.6f, n, float(0.5 * dot(apart, apart))));
        };
        // |R(wo) - wi| = |R(wi) - wo|, but for the rounding of a chord to 32 bits, which the
        // exponent multiplies.
        found.near(brdf(in, out), brdf(out, in), 0x1p-23 * (2 * double(n) + 8));
    }
}

void splits(Bench& bench, Findings& found) {
    over_environments(found, [&](std::uint64_t seed, const Source& source, float n,
                                 const Directions& asked) {
        const host::GpuImage image = test::on_device(bench.gpu(), image_of(source));
        const auto queries = test::unclipped(asked);
        const auto whole = test::ask(bench.gpu(), bench.exact(), image, {.exponent = n}, queries);
        const ExactSettings small{.exponent = n,
                                  .nodes_per_step = std::uint64_t(1) << (8 + seed % 8)};
        const auto parts = test::ask(bench.gpu(), bench.exact(), image, small, queries, {1, 2, 1});
        found.holds(parts.averages == whole.averages, "the same bytes however it is split");
    });
}

} // namespace

Kind oracle_facts() {
    return {
        "Facts, over 20 random environments each",
        {
            {"O01", "constant light of any brightness", "stays", constant_light},
            {"O02", "3 L + M", "3 P[L] + P[M]", linearity},
            {"O03", "any light", "no average leaves the range of the light", maximum},
            {"O04", "the mean of the averages over the sphere", "is the light's: 1e-3 of a map's",
             mean_of_averages},
            {"O05", "a harmonic of random degree and order", "times its eigenvalue", eigenvalues},
            {"O06", "rotations of the cube", "turn the averages: 1e-4", rotations},
            {"O07", "one texel in the dark", "its solid angle times the lobe; never brighter",
             lone_texel},
            {"O08", "n = 1e5 at the middle of a texel", "the texel", mirror},
            {"O09", "a half sphere", "1 before it, 0 behind it, 1/2 on its edge", half_sphere},
            {"O10", "n = 0 of a direction and its opposite", "add up to twice the mean: 1e-5",
             hemisphere_mean},
            {"O11", "light times 2^k", "averages times 2^k, to the bit", scaling},
            {"O12", "channels swapped", "averages swapped, to the bit", channels},
            {"O13", "the same again", "the same bytes", twice},
            {"O14", "a sphere in constant light", "kd + ks W(N.R, n) at each pixel it covers",
             white_sphere},
            {"O15", "directions swapped", "the same reflectance", reciprocity},
            {"O16", "work split otherwise", "the same bytes", splits},
        }};
}

} // namespace lobelia::hard
