#include <cfenv>
#include <cfloat>
#include <cmath>
#include <limits>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <lobelia/clipped_tables.h>

#include "bench.h"
#include "catalogue.h"
#include "odd_floats.h"
#include "support/harmonics.h"
#include "support/oracle.h"
#include "support/qualities.h"

// A: the lobe's numbers.
namespace lobelia::hard {
namespace {

void against_truth(Bench& bench, Findings& found, const Source& source, float n,
                   const Directions& axes, double allowed = 1.0) {
    found.at("n " + text(n) + ", " + test::shape_of(source));
    const std::vector<Average> averages = bench.exact(source, n, axes);
    found.sound(colours(averages));
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const Rgb truth = lobe_average(source, oracle::normalised(axes[i]), double(n));
        for (std::size_t c = 0; c < 3; ++c)
            found.exact(double(averages[i][c]), truth[c], test::largest(source)[c], double(n),
                        allowed);
    }
}

void exponent_zero(Bench& bench, Findings& found) {
    const auto front = [](Direction d) { return d.z > 0 ? Rgb{1, 2, 4} : Rgb{}; };
    for (const Source& half : {oracle::panorama_of(64, 32, front), oracle::cube_of(16, front)}) {
        found.at("half sphere, " + test::shape_of(half));
        const auto averages = bench.exact(half, 0, {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}});
        for (std::size_t c = 0; c < 3; ++c) {
            const double light = double(1 << c);
            found.near(double(averages[0][c]), light, SUMMATION);
            found.within(double(averages[1][c]), 1e-6);
            found.near(double(averages[2][c]), light / 2, SUMMATION);
            found.near(double(averages[3][c]), light / 2, SUMMATION);
        }
    }
    against_truth(bench, found, oracle::random_panorama(Scene::noise, 17, 9, 1), 0, axes(8, 1));
    against_truth(bench, found, oracle::random_cube(Scene::noise, 4, 2), 0, axes(8, 2));
}

void nearly_zero(Bench& bench, Findings& found) {
    // d/dn (n + 1) c^n at 0 is 1 + ln c, whose mean absolute value over c in [0, 1] is 2 / e.
    const Source source = oracle::random_panorama(Scene::noise, 17, 9, 3);
    const double brightest = test::largest(source)[0];
    const Directions asked = axes(12, 3);
    const std::vector<Average> at_zero = bench.exact(source, 0, asked);
    for (float n : {1e-30f, 1e-6f, 1e-3f, 0.01f}) {
        found.at("n " + text(n));
        const std::vector<Average> near_zero = bench.exact(source, n, asked);
        for (std::size_t i = 0; i < asked.size(); ++i)
            found.within(std::abs(double(near_zero[i][0]) - double(at_zero[i][0])),
                         2 / std::exp(1.0) * double(n) * brightest +
                             2 * SUMMATION * double(at_zero[i][0]));
    }
    against_truth(bench, found, source, 0.5f, asked);
}

void low_exponents(Bench& bench, Findings& found) {
    constexpr int SIZE = 64;
    // Texels hold the light of their middles: off by h^2 / 24 times the Laplacian, -l (l + 1) Y,
    // and twice that through the weight's slope.
    constexpr double SAMPLING = 0.5 * 3 * (2.0 / SIZE) * (2.0 / SIZE) / 24;
    const Directions asked = axes(8, 4);
    for (int l = 1; l <= 4; ++l) {
        const Source source = oracle::cube_of(SIZE, [l](Direction d) {
            return Rgb{1 + 0.5 * oracle::harmonic(l, 0, d), 1 + 0.5 * oracle::harmonic(l, l, d),
                       1 + 0.5 * oracle::harmonic(l, -1, d)};
        });
        const host::Image image = image_of(source);
        for (float n : {1.0f, 2.0f, 3.0f}) {
            found.at("n " + text(n) + ", degree " + std::to_string(l));
            const std::vector<Average> averages = bench.exact(image, n, asked);
            const double scale = 0.5 * oracle::lobe_eigenvalue(double(n), l);
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const Rgb truth{1 + scale * oracle::harmonic(l, 0, asked[i]),
                                1 + scale * oracle::harmonic(l, l, asked[i]),
                                1 + scale * oracle::harmonic(l, -1, asked[i])};
                for (std::size_t c = 0; c < 3; ++c)
                    found.within(std::abs(double(averages[i][c]) - truth[c]),
                                 SAMPLING * l * (l + 1) + SUMMATION);
            }
        }
    }
}

void a_thousand(Bench& bench, Findings& found) {
    Directions inside; // no sun on a horizon: there the truth itself changes in the last digit
    for (const Direction& d : axes(16, 5)) inside.push_back(d);
    against_truth(bench, found, oracle::random_cube(Scene::noise, 16, 6), 1e3f, inside, 1e-5);
    against_truth(bench, found, oracle::random_panorama(Scene::noise, 64, 32, 7), 1e3f, inside,
                  1e-5);
    against_truth(bench, found, oracle::random_panorama(Scene::smooth, 17, 9, 8), 1e3f, inside,
                  1e-5);
}

Directions telling_axes(int size) {
    Directions asked = axes(10, 9);
    for (int face = 0; face < 6; ++face)
        for (auto [x, y] : {std::pair{0.0, 0.5}, {0.5, 0.5}, {0.0, 0.0}, {1.0, 0.5}})
            asked.push_back(oracle::cube_direction(face, x * size, y * size, size));
    return asked;
}

void furnace(Bench& bench, Findings& found, float n) {
    const host::Image light = even_cube(64, 1, 0.18f, 37);
    const double truth[] = {1, double(0.18f), 37};
    const Directions asked = telling_axes(64);
    const auto look = [&](const std::vector<Average>& averages, double allowed) {
        found.sound(colours(averages));
        for (const Average& average : averages)
            for (std::size_t c = 0; c < 3; ++c) found.near(double(average[c]), truth[c], allowed);
    };
    found.at("exact, face 64");
    look(bench.exact(light, n, asked), SUMMATION);
    for (const Quality quality : test::QUALITIES) {
        found.at("map of quality " + std::to_string(int(quality)));
        const test::Prefiltered maps = bench.maps(light, {{n}, false, quality});
        look(bench.read(maps, 0, asked), HALF + 1e-5);
    }
}

void furnace_4(Bench& bench, Findings& found) {
    furnace(bench, found, 1e4f);
}
void furnace_5(Bench& bench, Findings& found) {
    furnace(bench, found, 1e5f);
}

void furnace_6(Bench& bench, Findings& found) {
    furnace(bench, found, 1e6f);
    // The lobe is a thousandth of a radian wide: what it sees at a texel's middle is that texel.
    const Source source = oracle::random_cube(Scene::noise, 64, 10);
    Directions middles;
    std::vector<Rgb> mirrored;
    for (int i = 0; i < 20; ++i) {
        const int face = i % 6, x = (i * 37) % 64, y = (i * 11) % 64;
        middles.push_back(source.direction(face, x, y));
        mirrored.push_back(source.texel(face, x, y));
    }
    found.at("exact, against the mirror");
    const std::vector<Average> averages = bench.exact(source, 1e6f, middles);
    for (std::size_t i = 0; i < middles.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            found.exact(double(averages[i][c]), mirrored[i][c], 0, 1e6, SUMMATION);
}

// Everything that takes an exponent.
void refused_everywhere(Findings& found, float n) {
    found.at("n " + text(n));
    found.refused(Exact::sizes(CubeMap{VK_NULL_HANDLE, VK_FORMAT_R32G32B32A32_SFLOAT, 4},
                               {.exponent = n, .query_count = 1}),
                  "0 to 1e6");
    found.refused(PrefilterPlan::make({.exponents = {&n, 1}, .source_size = 64}), "1e6");
    const auto material = host::check_material(test::grey(0.5f, 0.5f, n), false);
    found.refused(material ? material->message : "", "from 0 to 1000000");
}

void too_sharp(Bench&, Findings& found) {
    for (float n = 1e7f; n < 1e38f; n *= 10) refused_everywhere(found, n);
    for (float n : {std::nextafter(1e6f, 2e6f), FLT_MAX}) refused_everywhere(found, n);
}
void infinite_exponent(Bench&, Findings& found) {
    refused_everywhere(found, INFINITE);
}
void exponent_not_a_number(Bench&, Findings& found) {
    for (float n : {NOT_A_NUMBER, -NOT_A_NUMBER, std::numeric_limits<float>::signaling_NaN()})
        refused_everywhere(found, n);
}

void negative_exponent(Bench& bench, Findings& found) {
    for (float n : {-FLT_TRUE_MIN, -1e-6f, -1.0f, -64.0f, -INFINITE}) refused_everywhere(found, n);
    found.at("n -0");
    const Source source = oracle::random_panorama(Scene::noise, 17, 9, 3);
    found.holds(bench.exact(source, -0.0f, axes(8, 1)) == bench.exact(source, 0.0f, axes(8, 1)),
                "-0 gives the bytes of 0");
}

void lists(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::suns, 64, 11));
    const std::vector<float> in_order{0.5f, 1, 16, 64, 64, 700};
    const test::Prefiltered sorted = bench.maps(source, {in_order});
    for (const std::vector<float>& list :
         {std::vector<float>{700, 64, 0.5f, 64, 1, 16}, {64, 16, 700, 0.5f, 1, 64}}) {
        found.at("from n " + text(list[0]) + " on");
        const test::Prefiltered other = bench.maps(source, {list});
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto place = std::find(in_order.begin(), in_order.end(), list[i]);
            found.holds(bench.stored(other, i).texels ==
                            bench.stored(sorted, std::size_t(place - in_order.begin())).texels,
                        "the list's order changes no map");
        }
    }
    found.at("no exponents");
    found.refused(PrefilterPlan::make({.source_size = 64}), "");
}

void furnace_sphere(Bench& bench, Findings& found, float diffuse, float specular) {
    const EvenSphere sphere(bench, 24, 16);
    oracle::Random random(12);
    for (float n : {0.0f, 1.0f, 4.8f, 64.0f, 1e3f, 1e6f}) {
        found.at("n " + text(n));
        const SphereView view{.camera = test::random_camera(random),
                              .material = test::grey(diffuse, specular, n),
                              .width = 24,
                              .height = 16};
        const host::Image picture = sphere.draw(view);
        found.sound(picture.texels);
        const oracle::Camera camera = test::oracle_camera(view);
        for (std::uint32_t y = 0; y < view.height; ++y)
            for (std::uint32_t x = 0; x < view.width; ++x) {
                const float* pixel = picture.texel(0, x, y);
                const auto hit = oracle::meet_sphere(camera.eye, ray(camera, x + 0.5, y + 0.5));
                if (!hit || pixel[3] < 1.0f) continue;
                const double cosine = dot(hit->normal, hit->view);
                found.within(std::abs(double(pixel[0]) - double(diffuse) -
                                      double(specular) * oracle::albedo(cosine, double(n))),
                             test::furnace_tolerance(cosine, 1.0));
            }
    }
}

void all_light_reflected(Bench& bench, Findings& found) {
    furnace_sphere(bench, found, 0.25f, 0.75f);
}

void more_light_than_comes(Bench& bench, Findings& found) {
    furnace_sphere(bench, found, 0.75f, 1.5f);
    found.at("kd + ks 2.25");
    const auto refused = host::check_material(test::grey(0.75f, 1.5f, 4), false);
    found.refused(refused ? refused->message : "", "kd + ks is 0.75 + 1.5 = 2.25");
    found.holds(!host::check_material(test::grey(0.75f, 1.5f, 4), true), "allowed when asked for");
}

void bad_reflectance(Bench&, Findings& found) {
    for (float bad : {-1e-30f, -1.0f, NOT_A_NUMBER, INFINITE, -INFINITE})
        for (std::size_t channel = 0; channel < 3; ++channel) {
            found.at(text(bad) + " in channel " + std::to_string(channel));
            const char* names[] = {"red", "green", "blue"};
            Material diffuse = test::grey(0.25f, 0.25f, 4), specular = diffuse;
            diffuse.diffuse[channel] = bad;
            specular.specular[channel] = bad;
            for (const Material& material : {diffuse, specular}) {
                const auto refused = host::check_material(material, true);
                found.refused(refused ? refused->message : "", names[channel]);
            }
        }
}

void no_reflectance(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, 16, 16, false);
    for (float n : {0.0f, 64.0f, 1e6f}) {
        found.at("n " + text(n) + " under 1e9");
        host::Image picture =
            sphere.draw({.material = test::grey(0, 0, n), .background = false}, 1e9f);
        for (std::size_t i = 3; i < picture.texels.size(); i += 4) picture.texels[i] = 0;
        found.holds(picture.texels == std::vector<float>(picture.texels.size(), 0.0f),
                    "all colours are 0");
    }
}

void far_reflectance(Bench& bench, Findings& found) {
    const EvenSphere sphere(bench, 16, 16, false);
    const auto colour = [&](float kd, float ks) {
        return sphere.draw({.material = test::grey(kd, ks, 64), .background = false}).texels;
    };
    const std::vector<float> diffuse = colour(1, 0), specular = colour(0, 1);
    for (int power : {-100, -40, 40, 99}) {
        found.at("2^" + std::to_string(power));
        const float scale = std::ldexp(1.0f, power);
        const std::vector<float> far_diffuse = colour(scale, 0), far_specular = colour(0, scale);
        bool same = true;
        for (std::size_t i = 0; i < diffuse.size(); ++i)
            same = same && (i % 4 == 3 || (far_diffuse[i] == scale * diffuse[i] &&
                                           far_specular[i] == scale * specular[i]));
        found.holds(same, "scales to the bit");
        found.sound(far_diffuse);
        found.sound(far_specular);
    }
}

void changing_exponent(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::suns, 64, 13));
    const auto bytes = [&](float n) { return bench.stored(bench.maps(source, {{n}}), 0).texels; };
    const Directions asked = axes(8, 14);
    for (auto [a, b] : {std::pair{16.0f, 700.0f}, {0.5f, 1e4f}}) {
        found.at("n " + text(a) + ", " + text(b) + ", " + text(a));
        const auto first = bytes(a);
        const auto exact_first = bench.exact(source, a, asked);
        bytes(b);
        bench.exact(source, b, asked);
        found.holds(bytes(a) == first, "maps have the first bytes again");
        found.holds(bench.exact(source, a, asked) == exact_first, "so have exact averages");
    }
}

// Sets the thread's rounding, or where it can lets it flush denormals, and puts the old mode back.
class FloatingPointMode {
public:
    explicit FloatingPointMode(int rounding, bool flush = false) {
        std::fegetenv(&old_);
        std::fesetround(rounding);
#ifdef __SSE__
        if (flush) _mm_setcsr(_mm_getcsr() | 0x8040); // flush to zero, denormals are zero
#else
        (void)flush;
#endif
    }
    ~FloatingPointMode() {
        std::fesetenv(&old_);
    }

private:
    std::fenv_t old_;
};

void floating_point_modes(Bench& bench, Findings& found) {
    const host::Image source = image_of(oracle::random_cube(Scene::suns, 16, 15));
    const Directions asked = axes(12, 16);
    struct Results {
        std::vector<Average> exact, read;
        Ladder ladder;
    };
    const auto results = [&] {
        const test::Prefiltered maps = bench.maps(source, {{0.5f, 64, 1e4f}});
        Results all{bench.exact(source, 64, asked), {}, ladder_for(Taps::two, 4.8f, 300)};
        for (std::size_t i = 0; i < maps.maps.size(); ++i) {
            const auto more = bench.read(maps, i, asked);
            all.read.insert(all.read.end(), more.begin(), more.end());
        }
        return all;
    };
    const Results plain = results();
    {
        found.at("denormals flushed");
        const FloatingPointMode mode(FE_TONEAREST, true);
        const Results flushed = results();
        found.holds(flushed.exact == plain.exact && flushed.read == plain.read, "same bytes");
        found.holds(flushed.ladder.lowest == plain.ladder.lowest, "same ladder");
    }
    for (int rounding : {FE_DOWNWARD, FE_UPWARD}) {
        found.at(rounding == FE_DOWNWARD ? "rounding down" : "rounding up");
        const FloatingPointMode mode(rounding);
        const Results rounded = results();
        for (std::size_t i = 0; i < plain.exact.size(); ++i)
            found.near(double(rounded.exact[i][0]), double(plain.exact[i][0]), SUMMATION);
        for (std::size_t i = 0; i < plain.read.size(); ++i) // to the half beside it
            found.near(double(rounded.read[i][0]), double(plain.read[i][0]), 2 * HALF);
    }
}

} // namespace

Kind lobe_numerics() {
    return {"Lobe numerics",
            {
                {"A01", "n = 0", "the mean over the half sphere, its edge included", exponent_zero},
                {"A02", "n = 1e-30, 1e-6, 1e-3, 0.5",
                 "goes to n = 0 without a step: it differs by at most 2/e n max L", nearly_zero},
                {"A03", "n = 1, 2, 3 under harmonics of degree 1 to 4",
                 "each degree times its eigenvalue", low_exponents},
                {"A04", "n = 1e3", "1e-5 of the double-precision integral", a_thousand},
                {"A05", "n = 1e4 on faces of 64",
                 "constant light stays, at middles, edges and corners", furnace_4},
                {"A06", "n = 1e5 on faces of 64", "the same", furnace_5},
                {"A07", "n = 1e6 on faces of 64", "the same, and the mirror's texel at its middle",
                 furnace_6},
                {"A08", "n beyond 1e6 to the largest float", "refused by all that take an exponent",
                 too_sharp},
                {"A09", "n infinite", "refused", infinite_exponent},
                {"A10", "n = NaN, of either sign, signalling", "refused", exponent_not_a_number},
                {"A11", "n < 0, and -0", "refused; -0 is 0 to the bit", negative_exponent},
                {"A12", "lists unsorted, with duplicates, empty",
                 "each map as if alone; an empty list is refused", lists},
                {"A13", "kd + ks = 1", "shows kd + ks W(N.R, n) in constant light",
                 all_light_reflected},
                {"A14", "kd + ks > 1", "refused, or when allowed exactly linear",
                 more_light_than_comes},
                {"A15", "kd or ks negative, NaN or infinite, in each channel",
                 "refused, naming the channel", bad_reflectance},
                {"A16", "kd = ks = 0 under light of 1e9", "exactly black", no_reflectance},
                {"A17", "kd or ks from 2^-100 to 2^99", "linear to the bit", far_reflectance},
                {"A18", "n changes from call to call", "no call sees another's tables",
                 changing_exponent},
                {"A19", "n as \"0,5\", \"1e3x\", \"\", \"0x10\", under a German locale",
                 "refused; numbers are read alike in every locale", nullptr,
                 "ProcessTest.DoesNotDependOnTheLocale"},
                {"A20", "the host flushes denormals or rounds another way",
                 "same bytes; a rounding's difference", floating_point_modes},
            }};
}

} // namespace lobelia::hard
