// What lib/expected_error_table.inc holds, and whether it keeps its promise:
//     measure_expected_error table [--references DIR] > lib/expected_error_table.inc
//     measure_expected_error check [--references DIR]
// `table` takes the worst over four hard photographs and three made environments, `check` all
// others; it prints what was measured over what expected_error.h says, the worst for each lobe, and
// ends in 1 where that is above 1. DIR keeps the references of spheres, which take minutes.

#include <algorithm>
#include <cstdio>
#include <cstring>

#include <lobelia/expected_error.h>

#include "checked_panoramas.h"
#include "judged.h"
#include "made_panoramas.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

constexpr const char* TABLE_FROM[] = {"forest", "studio",     "sunrise",       "interior",
                                      "lamps",  "soft boxes", "noise and suns"};
constexpr float MAP_EXPONENTS[] = {0,   0.5f, 1,    2,    4.8f, 8,    11,   16,  22,  32,
                                   37,  45,   64,   90,   128,  150,  181,  256, 300, 362,
                                   512, 700,  1024, 1448, 2048, 2896, 4096, 1e4f};
constexpr float SPHERE_EXPONENTS[] = {0, 1, 2, 4.8f, 16, 64, 256, 1024, 4096, 1e4f};

struct Method {
    const char* name; // in the table
    SphereMethod method;
};
constexpr Method METHODS[] = {{"one_tap", SphereMethod::one_tap},
                              {"two_tap", SphereMethod::two_tap},
                              {"hybrid", SphereMethod::hybrid}};

std::vector<Judged> environments(host::Gpu& gpu, const std::string& references, bool table) {
    std::vector<Judged> chosen;
    const auto add = [&](const std::string& name, host::Image image) {
        const bool is_of_table =
            std::find(std::begin(TABLE_FROM), std::end(TABLE_FROM), name) != std::end(TABLE_FROM);
        if (is_of_table == table) chosen.emplace_back(gpu, name, std::move(image), references);
    };
    for (const std::string& name : REAL_PANORAMAS) add(name, real_panorama(name));
    for (const MadePanorama& made : made_panoramas()) add(made.name, made.image);
    add("sky with suns", sky_with_suns(1024));
    add("sky with suns, 256", sky_with_suns(256));
    add("room with window", room_with_window(1024));
    return chosen;
}

const char* name_of(Quality quality) {
    return quality == Quality::fast ? "fast" : quality == Quality::normal ? "normal" : "high";
}

void print_row(const std::vector<double>& values, const char* end = ",") {
    std::printf("    {");
    for (std::size_t i = 0; i < values.size(); ++i)
        std::printf("%s%s%.2e", i ? "," : "", i == 0 ? "" : i % 9 ? " " : "\n     ", values[i]);
    std::printf("}%s", end);
}

void print_exponents(const char* name, std::span<const float> exponents) {
    std::printf("constexpr double %s[] = {", name);
    for (std::size_t i = 0; i < exponents.size(); ++i)
        std::printf("%s%g", i == 0 ? "" : i % 16 ? ", " : ",\n    ", double(exponents[i]));
    std::printf("};\n");
}

/// The larger of each two.
void raise(std::vector<double>& worst, const std::vector<double>& found) {
    worst.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) worst[i] = std::max(worst[i], found[i]);
}

template <class Errors>
void print_spheres(const char* name, std::size_t size, std::span<const Method> methods,
                   std::vector<Judged>& judged, Errors errors) {
    std::printf("\nconstexpr double %s[][3][%zu] = { // by method and quality\n", name, size);
    for (const Method& method : methods) {
        std::printf("    { // %s\n", method.name);
        for (const Quality quality : QUALITIES) {
            std::vector<double> worst;
            for (Judged& one : judged) raise(worst, errors(one, method.method, quality));
            print_row(worst);
            std::printf(" // %s\n", name_of(quality));
            std::fprintf(stderr, "%s %s\n", method.name, name_of(quality));
        }
        std::printf("    },\n");
    }
    std::printf("};\n");
}

void print_table(std::vector<Judged> judged) {
    std::printf("// Written by measure_expected_error: the worst over\n// ");
    for (const char* name : TABLE_FROM)
        std::printf("%s%s", name == TABLE_FROM[0] ? "" : ", ", name);
    std::printf("\n\n");
    print_exponents("MAP_EXPONENTS", MAP_EXPONENTS);
    std::printf("constexpr double MAP_ERRORS[][%zu] = { // by quality; then Lambert's\n",
                std::size(MAP_EXPONENTS) + 1);
    for (const Quality quality : QUALITIES) {
        std::vector<double> worst;
        for (Judged& one : judged) {
            raise(worst, one.map_errors(quality, MAP_EXPONENTS));
            std::fprintf(stderr, "maps %s %s\n", name_of(quality), one.name().c_str());
        }
        print_row(worst);
        std::printf(" // %s\n", name_of(quality));
    }
    std::printf("};\n\n");
    print_exponents("SPHERE_EXPONENTS", SPHERE_EXPONENTS);
    std::vector<double> diffuse;
    for (const Quality quality : QUALITIES) {
        diffuse.push_back(0);
        for (Judged& one : judged)
            diffuse.back() = std::max(
                diffuse.back(), one.sphere_error(SphereMethod::two_tap, quality, std::nullopt));
    }
    std::printf("constexpr double DIFFUSE_ERRORS[] = // by quality\n");
    print_row(diffuse, ";\n");
    print_spheres("SPECULAR_ERRORS", std::size(SPHERE_EXPONENTS), METHODS, judged,
                  [](Judged& one, SphereMethod method, Quality quality) {
                      std::vector<double> found;
                      for (const float exponent : SPHERE_EXPONENTS)
                          found.push_back(one.sphere_error(method, quality, exponent));
                      return found;
                  });
}

/// What was measured over what was to be expected: the largest, and where.
struct Ratio {
    double worst = 0;
    std::string where;

    void add(double measured, double expected, const std::string& place) {
        if (measured / expected <= worst) return;
        worst = measured / expected;
        where = place;
    }
    bool print(const char* what) const {
        std::printf("| %s | %.2f | %s |\n", what, worst, where.c_str());
        return worst <= 1;
    }
};

// Exponents between the table's.
constexpr float CHECKED_MAPS[] = {1, 3, 6, 13, 27, 50, 75, 110, 220, 420, 850, 1700, 3400, 6000};
constexpr float CHECKED_SPHERES[] = {1, 3, 9, 30, 110, 500, 2000};

bool check(std::vector<Judged> judged) {
    bool kept = true;
    std::printf("| | measured over expected, at worst | where |\n| --- | --- | --- |\n");
    for (const Quality quality : QUALITIES) {
        Ratio ratio;
        for (Judged& one : judged) {
            const std::vector<double> found = one.map_errors(quality, CHECKED_MAPS);
            const auto place = [&](float n) {
                return one.name() + ", n = " + std::to_string(int(n));
            };
            for (std::size_t i = 0; i < std::size(CHECKED_MAPS); ++i)
                ratio.add(found[i], expected_map_error(quality, CHECKED_MAPS[i], one.face(quality)),
                          place(CHECKED_MAPS[i]));
            ratio.add(found.back(), expected_lambert_error(quality, one.face(quality)),
                      one.name() + ", Lambert");
        }
        kept = ratio.print((std::string("maps, ") + name_of(quality)).c_str()) && kept;
        std::fflush(stdout);
    }
    const auto spheres = [&](std::span<const Method> methods, auto add) {
        for (const Method& method : methods)
            for (const Quality quality : QUALITIES) {
                Ratio ratio;
                for (Judged& one : judged) add(ratio, one, method.method, quality);
                const std::string row = std::string(method.name) + ", " + name_of(quality);
                kept = ratio.print(row.c_str()) && kept;
                std::fflush(stdout);
            }
    };
    spheres(METHODS, [](Ratio& ratio, Judged& one, SphereMethod method, Quality quality) {
        ratio.add(one.sphere_error(method, quality, std::nullopt),
                  expected_diffuse_error(method, quality, one.face(quality)), one.name() + ", kd");
        for (const float n : CHECKED_SPHERES)
            ratio.add(one.sphere_error(method, quality, n),
                      expected_specular_error(method, quality, n, n, one.face(quality)),
                      one.name() + ", n = " + std::to_string(int(n)));
    });
    return kept;
}

} // namespace
} // namespace lobelia::test

int main(int count, char** arguments) {
    using namespace lobelia::test;
    const bool table = count > 1 && std::strcmp(arguments[1], "table") == 0;
    const std::string references =
        count > 3 && std::strcmp(arguments[2], "--references") == 0 ? arguments[3] : "";
    auto gpu = value_of(lobelia::host::Gpu::create());
    auto judged = environments(gpu, references, table);
    if (!table) return check(std::move(judged)) ? 0 : 1;
    print_table(std::move(judged));
    return 0;
}
