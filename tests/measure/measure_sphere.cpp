// Error and time of the sphere's methods: measure_sphere [--quality NAME] [PANORAMA...].
//
// Error against SphereMethod::reference over the pixels that the sphere covers and R G B, each
// panorama seen from a side of its own; the mean over the panoramas of
//     pointwise: root mean square of |x - exact| / (|exact| + 1e-3 mean)
//     image: root mean square of x - exact over that of exact.
// Time: CPU time of the sphere pass at 512 x 512 in each panorama, the median of several draws,
// over that of a mirror with one trilinear fetch in the same run. --times measures it alone.
//
// --references DIR keeps the reference's colours there, which take minutes a panorama and are the
// same for every quality. Remove them when the reference changes. --csv FILE adds the errors on
// each panorama to a table, of which expected_error.h is made.

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>

#include <CLI/CLI.hpp>

#include "host/sphere_inputs.h"
#include "small_sphere.h"
#include "sphere_timing.h"
#include "support/error_measures.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

/// What is measured; to add a method is to add a line.
struct Rung {
    const char* name;
    SphereMethod method;
    std::uint32_t samples = 64;
};
constexpr Rung RUNGS[] = {
    {"kurt2019", SphereMethod::kurt2019},
    {"sh2", SphereMethod::sh2},
    {"sh4", SphereMethod::sh4},
    {"split-sum", SphereMethod::split_sum},
    {"one-tap", SphereMethod::one_tap},
    {"two-tap", SphereMethod::two_tap},
    {"hybrid", SphereMethod::hybrid},
    {"importance, 8", SphereMethod::importance, 8},
    {"importance, 32", SphereMethod::importance, 32},
    {"importance, 64", SphereMethod::importance, 64},
    {"importance, 256", SphereMethod::importance, 256},
};

const Rung& rung_of(SphereMethod method) {
    return *std::find_if(std::begin(RUNGS), std::end(RUNGS),
                         [&](const Rung& rung) { return rung.method == method; });
}

struct Case {
    const char* name;
    Material material;
};
constexpr Material white(float diffuse, float specular, float exponent) {
    return {{diffuse, diffuse, diffuse}, {specular, specular, specular}, exponent};
}
constexpr Case CASES[] = {
    {"kd, n = 4.8", white(1, 0, 4.8f)}, {"kd, n = 64", white(1, 0, 64)},
    {"ks, n = 1", white(0, 1, 1)},      {"ks, n = 4.8", white(0, 1, 4.8f)},
    {"ks, n = 16", white(0, 1, 16)},    {"ks, n = 64", white(0, 1, 64)},
    {"ks, n = 256", white(0, 1, 256)},  {"ks, n = 1024", white(0, 1, 1024)},
};

struct Options {
    Quality quality = Quality::normal;
    bool times = false;     // alone
    std::string references; // folder; empty: keeps none
    std::string table;      // file; empty: none
    std::vector<std::string> panoramas = REAL_PANORAMAS;
};

/// Methods that read no maps of Prefilter's have no quality and are measured at normal.
bool is_measured(const Rung& rung, const Options& options) {
    return options.quality == Quality::normal ||
           (rung.method != SphereMethod::kurt2019 && rung.method != SphereMethod::importance);
}

const char* name_of(Quality quality) {
    return quality == Quality::fast ? "fast" : quality == Quality::normal ? "normal" : "high";
}

void add_row(const Options& options, const std::string& panorama, const Rung& rung,
             const Material& material, const oracle::ErrorMeasures& error) {
    std::ofstream table(options.table, std::ios::app);
    if (table.tellp() == 0)
        table << "environment,quality,method,samples,lobe,exponent,rms,image_rms\n";
    const std::string name = rung.name;
    const std::size_t comma = name.find(',');
    table << panorama << ',' << name_of(options.quality) << ',' << name.substr(0, comma) << ',';
    if (comma != std::string::npos) table << rung.samples;
    table << (material.specular[0] > 0.0f ? ",ks," : ",kd,") << material.exponent << ','
          << error.pointwise_rms << ',' << error.image_rms << '\n';
}

struct Errors {
    double pointwise[std::size(RUNGS)][std::size(CASES)] = {};
    double image[std::size(RUNGS)][std::size(CASES)] = {};
};

void add_errors(host::Gpu& gpu, const std::string& panorama, const Options& options,
                Errors& errors) {
    const auto environment =
        value_of(host::upload_environment(gpu, real_panorama(panorama), 0, options.quality));
    for (std::size_t i = 0; i < std::size(CASES); ++i) {
        const Material& material = CASES[i].material;
        host::RenderSettings settings{.view = small_sphere(panorama, material),
                                      .quality = options.quality};
        const auto drawn = [&](SphereMethod method, std::uint32_t samples) {
            settings.method = method;
            settings.samples = samples;
            return sphere_colours(value_of(host::render(gpu, environment, settings)).picture);
        };
        const std::vector<double> exact =
            kept_reference(options.references, panorama, material,
                           [&] { return drawn(SphereMethod::reference, 1); });
        for (std::size_t k = 0; k < std::size(RUNGS); ++k) {
            if (!is_measured(RUNGS[k], options)) continue;
            const auto error =
                oracle::measure_error(drawn(RUNGS[k].method, RUNGS[k].samples), exact);
            errors.pointwise[k][i] += error.pointwise_rms;
            errors.image[k][i] += error.image_rms;
            if (!options.table.empty()) add_row(options, panorama, RUNGS[k], material, error);
        }
    }
}

void print_errors(const Errors& errors, const Options& options) {
    const auto panoramas = double(options.panoramas.size());
    std::printf("| pointwise / image |");
    for (const Case& one : CASES) std::printf(" %s |", one.name);
    std::printf("\n");
    for (std::size_t k = 0; k < std::size(RUNGS); ++k) {
        if (!is_measured(RUNGS[k], options)) continue;
        std::printf("| %s |", RUNGS[k].name);
        for (std::size_t i = 0; i < std::size(CASES); ++i)
            std::printf(" %.2g / %.2g |", errors.pointwise[k][i] / panoramas,
                        errors.image[k][i] / panoramas);
        std::printf("\n");
    }
}

void print_times(host::Gpu& gpu, const std::string& panorama, const Options& options) {
    const auto environment =
        value_of(host::upload_environment(gpu, real_panorama(panorama), 0, options.quality));
    std::vector<SphereTiming> lobes[2];
    std::uint32_t suns = 0;
    for (int i = 0; i < 2; ++i) {
        SphereTimer timer(gpu, environment, white(i == 0 ? 0.3f : 0.0f, 0.6f, 64), options.quality);
        for (const Rung& rung : RUNGS)
            if (is_measured(rung, options)) timer.add(rung.name, rung.method, rung.samples);
        for (const SphereMethod method :
             {SphereMethod::one_tap, SphereMethod::two_tap, SphereMethod::hybrid})
            timer.add_without_suns(std::string(rung_of(method).name) + ", suns left out", method);
        lobes[i] = timer.run();
        suns = timer.suns();
    }
    std::printf("\n| %s, %u suns | kd and ks | ks |\n| --- | --- | --- |\n", panorama.c_str(),
                suns);
    for (std::size_t k = 0; k < lobes[0].size(); ++k)
        std::printf("| %s | %.2f | %.2f |\n", lobes[0][k].name.c_str(), lobes[0][k].ratio,
                    lobes[1][k].ratio);
    std::printf("mirror: %.1f ms\n", lobes[0].front().milliseconds);
}

void measure(host::Gpu& gpu, const Options& options) {
    if (!options.times) {
        Errors errors;
        for (const std::string& panorama : options.panoramas)
            add_errors(gpu, panorama, options, errors);
        print_errors(errors, options);
    }
    for (const std::string& panorama : options.panoramas) print_times(gpu, panorama, options);
}

} // namespace
} // namespace lobelia::test

int main(int count, char** arguments) {
    using lobelia::Quality;
    lobelia::test::Options options;
    CLI::App program("Error and time of the sphere's methods");
    program.add_option("PANORAMA", options.panoramas);
    program.add_flag("--times", options.times);
    program.add_option("--references", options.references)->type_name("DIR");
    program.add_option("--csv", options.table)->type_name("FILE");
    program.add_option("--quality", options.quality)
        ->transform(CLI::CheckedTransformer(std::map<std::string, Quality>{
            {"fast", Quality::fast}, {"normal", Quality::normal}, {"high", Quality::high}}));
    CLI11_PARSE(program, count, arguments);
    auto gpu = lobelia::test::value_of(lobelia::host::Gpu::create());
    std::printf("%s\n", gpu.description().name.c_str());
    lobelia::test::measure(gpu, options);
}
