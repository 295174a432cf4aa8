#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "environment.h"
#include "gpu_choice.h"
#include "measure_page.h"
#include "measure_work.h"
#include "messages.h"
#include "parsed_option.h"
#include "program.h"
#include "verbs.h"

namespace lobelia::cli {

using host::Failure;
using host::Outcome;

namespace {

constexpr const char* BUILT_IN = "built-in";
// Readable on a phone, where the width of a picture is that of a few words.
constexpr const char* SVG = "svg size 640,560 dynamic background rgb \"white\" font \"sans,15\"";
constexpr const char* PNG =
    "pngcairo size 1280,1120 background rgb \"white\" font \"sans,15\" fontscale 1.6 linewidth 2 "
    "pointscale 1.5";

struct MeasureOptions {
    std::vector<std::string> environments;
    std::string folder;
    MeasurePlan plan;
    GpuChoice gpu;
};

Outcome<MeasurePlan> parse_tasks(std::string_view text) {
    MeasurePlan plan{.prefilter = false, .shade = false};
    while (true) {
        const std::string_view name = text.substr(0, text.find(','));
        if (name == "prefilter")
            plan.prefilter = true;
        else if (name == "shade")
            plan.shade = true;
        else
            return Failure{"\"" + std::string(name) +
                           "\" is no task; there are prefilter and shade"};
        if (name.size() == text.size()) return plan;
        text.remove_prefix(name.size() + 1);
    }
}

std::string name_of(const std::string& path) {
    return std::filesystem::path(path).stem().string();
}

void check_usage(const MeasureOptions& options) {
    std::vector<std::string> names;
    for (const std::string& path : options.environments) {
        const std::string name = name_of(path);
        if (std::find(names.begin(), names.end(), name) != names.end())
            throw CLI::ValidationError("ENV", "two environments are called " + name +
                                                  ", rename one or measure them apart");
        names.push_back(name);
    }
}

/// FNV-1a over the texels' bits: tells environments apart, not attackers.
std::string fingerprint(const host::Image& image) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto mix = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001b3; };
    mix(image.width);
    mix(image.height);
    for (const float value : image.texels) mix(std::bit_cast<std::uint32_t>(value));
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

Outcome<std::vector<MeasureSource>> read_sources(const MeasureOptions& options,
                                                 ProgressLine& progress) {
    if (options.environments.empty())
        return std::vector<MeasureSource>{{.name = BUILT_IN,
                                           .file = std::nullopt,
                                           .fingerprint = BUILT_IN,
                                           .face = host::default_face(host::BUILTIN_WIDTH)}};
    std::vector<MeasureSource> sources;
    for (const std::string& path : options.environments) {
        auto file = read_source(path, progress);
        if (!file) return file.error();
        const host::Image& image = (*file)->image;
        const std::uint32_t face =
            image.layout == host::Layout::cube ? image.width : host::default_face(image.width);
        std::string print = fingerprint(image);
        sources.push_back({.name = name_of(path),
                           .file = std::move(*file),
                           .fingerprint = std::move(print),
                           .face = face});
    }
    return sources;
}

std::string time_left(double seconds) {
    if (seconds < 90.0) return std::to_string(int(std::ceil(seconds))) + " s";
    return std::to_string(int(std::ceil(seconds / 60.0))) + " min";
}

/// The end of the cases that are compared with the one at `first`, and measured together.
std::size_t end_of_compared(const std::vector<MeasureCase>& cases, std::size_t first) {
    std::size_t end = first + 1;
    while (end < cases.size() && cases[end].task == cases[first].task &&
           cases[end].environment == cases[first].environment &&
           cases[end].exponent == cases[first].exponent)
        ++end;
    return end;
}

Outcome<Done> measure_all(host::Gpu& gpu, const std::vector<MeasureSource>& sources,
                          const MeasurePlan& plan, MeasureFolder& folder, ProgressLine& progress) {
    std::vector<MeasureCase> missing = measure_cases(sources, plan);
    std::erase_if(missing, [&](const MeasureCase& what) { return folder.has(what); });
    Measurer measurer(gpu, folder);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0, next; i < missing.size(); i = next) {
        next = end_of_compared(missing, i);
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        std::string step = "measuring " + std::to_string(i + 1) + " to " + std::to_string(next) +
                           " of " + std::to_string(missing.size());
        if (i > 0)
            step += ", about " +
                    time_left(passed.count() / double(i) * double(missing.size() - i)) + " left";
        progress.begin(step);
        const auto source = std::find_if(sources.begin(), sources.end(), [&](const auto& one) {
            return one.name == missing[i].environment;
        });
        const auto rows = measurer.measure({&missing[i], next - i}, *source);
        if (!rows) return rows.error();
        if (const auto kept = folder.add(*rows); !kept) return kept.error();
    }
    return Done{};
}

Outcome<std::string> run_gnuplot(const std::string& terminal, const std::string& script) {
    return run_program({"gnuplot", "-"}, "set terminal " + terminal + "\n" + script);
}

Outcome<Done> draw(const MeasureFolder& folder, ProgressLine& progress) {
    const MeasureSummary summary(folder.rows(), folder.head());
    const std::vector<MeasurePlot> plots = measure_plots(summary);
    std::vector<DrawnPlot> drawn;
    if (has_program("gnuplot")) {
        for (const MeasurePlot& plot : plots) {
            progress.begin("drawing " + plot.name);
            const auto svg = run_gnuplot(SVG, plot.script);
            if (!svg) return svg.error();
            const auto png = run_gnuplot(PNG, plot.script);
            if (!png) return png.error();
            if (const auto kept = folder.write(plot.name + ".svg", *svg); !kept)
                return kept.error();
            if (const auto kept = folder.write(plot.name + ".png", *png); !kept)
                return kept.error();
            drawn.push_back({plot, *svg});
        }
    } else {
        std::string names;
        for (const MeasurePlot& plot : plots) names += (names.empty() ? "" : ", ") + plot.name;
        say("warning: there is no gnuplot to draw with, so these pictures are missing, as .svg and "
            ".png: " +
            names +
            "; install it (Debian: gnuplot-nox) and give the same command again, which then only "
            "draws");
    }
    return folder.write("index.html", measure_page(summary, drawn));
}

Outcome<Done> measure(const MeasureOptions& options) {
    ProgressLine progress;
    const auto sources = read_sources(options, progress);
    if (!sources) return sources.error();
    auto gpu = start_gpu(options.gpu);
    if (!gpu) return gpu.error();
    auto folder = MeasureFolder::open(options.folder, *gpu, *sources);
    if (!folder) return folder.error();
    const auto measured = measure_all(*gpu, *sources, options.plan, *folder, progress);
    if (!measured) return measured.error();
    return draw(*folder, progress);
}

} // namespace

void add_measure(CLI::App& program, int& status) {
    const auto options = std::make_shared<MeasureOptions>();
    CLI::App* const verb =
        program.add_subcommand("measure", "shows what accuracy costs in time on this device");
    verb->add_option("ENV", options->environments,
                     "environment maps, OpenEXR or Radiance .hdr; default: a built-in one");
    verb->add_option("-o", options->folder,
                     "folder for measure.csv, measure.json, pictures and index.html; what was "
                     "measured into it before is not measured again")
        ->required()
        ->type_name("DIR");
    add_parsed(
        *verb, "--tasks", parse_tasks,
        [options](const MeasurePlan& tasks) {
            options->plan.prefilter = tasks.prefilter;
            options->plan.shade = tasks.shade;
        },
        "NAME,...", "prefilter, shade or both; default: both");
    verb->add_flag("--quick", options->plan.quick,
                   "fewer exponents, samples and sizes: under a minute on a CPU");
    add_gpu_options(*verb, options->gpu);
    verb->callback([options, &status] {
        check_usage(*options);
        const auto measured = measure(*options);
        status = measured ? SUCCEEDED : fail(measured.error().message);
    });
}

} // namespace lobelia::cli
