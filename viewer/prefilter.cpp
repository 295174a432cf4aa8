#include <algorithm>
#include <functional>
#include <memory>

#include "environment.h"
#include "gpu_choice.h"
#include "map_file.h"
#include "messages.h"
#include "numbers.h"
#include "parsed_option.h"
#include "prefilter_method.h"
#include "quality.h"
#include "report.h"
#include "tolerance.h"
#include "verbs.h"

namespace lobelia::cli {

namespace {

struct PrefilterOptions {
    std::string environment;
    std::vector<float> exponents;
    bool lambert = false;
    std::optional<host::PrefilterMethod> method; // else chain
    std::optional<std::uint32_t> samples;
    std::optional<Quality> quality;  // else normal
    std::optional<double> tolerance; // else none; see meet()
    host::Layout layout = host::Layout::cube;
    std::optional<std::uint32_t> face;
    std::optional<Size> size;
    std::string path;
    std::optional<FileKind> format;
    OutputFile output; // what the two say
    GpuChoice gpu;
    bool json = false;
};

Outcome<host::Layout> parse_layout(std::string_view text) {
    if (text == "cube") return host::Layout::cube;
    if (text == "latlong") return host::Layout::latlong;
    return host::Failure{"\"" + std::string(text) + "\" is no layout; there are cube and latlong"};
}

// Lambert's lobe is Phong's with exponent 1 about the normal. The levels of a cube map go from
// sharp to broad, as engines look them up by roughness.
std::vector<float> exponents_of(const PrefilterOptions& options) {
    std::vector<float> exponents;
    if (options.lambert) exponents.push_back(1.0f);
    exponents.insert(exponents.end(), options.exponents.begin(), options.exponents.end());
    if (options.output.kind == FileKind::ktx2)
        std::sort(exponents.begin(), exponents.end(), std::greater<>());
    return exponents;
}

void check_usage(const PrefilterOptions& options) {
    const std::vector<float> exponents = exponents_of(options);
    if (exponents.empty())
        throw CLI::ValidationError("--exponents", "give the lobes' exponents, or --lambert");
    for (std::size_t i = 0; i < exponents.size(); ++i)
        if (std::find(exponents.begin() + std::ptrdiff_t(i) + 1, exponents.end(), exponents[i]) !=
            exponents.end())
            throw CLI::ValidationError("--exponents",
                                       number_text(exponents[i]) + " is there twice");
    if (options.tolerance && (options.method || options.quality))
        throw CLI::ValidationError("--tolerance",
                                   "chooses --method and --quality; leave those out");
    if (options.samples && !(options.method && takes_samples(*options.method)))
        throw CLI::ValidationError("--samples",
                                   "is for --method importance and filtered-importance");
    if (options.face && options.layout != host::Layout::cube)
        throw CLI::ValidationError("--face", "is for --layout cube; latlong takes --size WxH");
    if (options.size && options.layout != host::Layout::latlong)
        throw CLI::ValidationError("--size", "is for --layout latlong; cube takes --face N");
    if (options.layout != host::Layout::cube && options.output.kind == FileKind::ktx2)
        throw CLI::ValidationError("--layout", "latlong is for OpenEXR; KTX2 holds a cube map");
}

host::PrefilterSettings settings_of(const PrefilterOptions& options) {
    host::PrefilterSettings settings{.method =
                                         options.method.value_or(host::PrefilterMethod::chain),
                                     .quality = options.quality.value_or(Quality::normal),
                                     .exponents = exponents_of(options),
                                     .layout = options.layout,
                                     .levels = options.output.kind == FileKind::ktx2};
    if (options.samples) settings.samples = *options.samples;
    if (options.face) settings.width = *options.face;
    if (options.size) {
        settings.width = options.size->width;
        settings.height = options.size->height;
    }
    return settings;
}

// What a reader of the file cannot see in its texels; docs/files.md has the meanings.
host::Metadata metadata_of(const host::PrefilterSettings& settings) {
    std::string exponents;
    for (const float exponent : settings.exponents)
        exponents += (exponents.empty() ? "" : ",") + number_text(exponent);
    host::Metadata metadata{{"lobelia:exponents", exponents},
                            {"lobelia:method", prefilter_method_name(settings.method)},
                            {"lobelia:scale", "1"},
                            {"lobelia:suns", "in the texels"}};
    if (settings.method == host::PrefilterMethod::chain)
        metadata.emplace_back("lobelia:quality", quality_name(settings.quality));
    if (takes_samples(settings.method))
        metadata.emplace_back("lobelia:samples", std::to_string(settings.samples));
    return metadata;
}

Outcome<Report> prefilter(const PrefilterOptions& options) {
    Report report;
    if (const auto valid = check_outputs({options.output}); !valid) return valid.error();

    ProgressLine progress;
    const auto source = read_source(options.environment, progress);
    if (!source) return source.error();
    auto gpu = start_gpu(options.gpu);
    if (!gpu) return gpu.error();
    host::PrefilterSettings settings = settings_of(options);
    if (const auto met = meet(options.tolerance, *gpu, shape_of(*source), settings); !met)
        return met.error();
    const auto environment = upload_source(*gpu, *source, 0, settings.quality, progress);
    if (!environment) return environment.error();

    progress.begin("prefiltering");
    const auto filtered = host::prefilter(*gpu, *environment, settings, progress.listener());
    if (!filtered) return filtered.error();

    progress.begin("writing");
    const auto written = write_outputs({options.output}, [&](const OutputFile& file) {
        return write_maps(file, filtered->maps, settings.exponents, metadata_of(settings));
    });
    if (!written) return written.error();

    report.gpu = gpu->description();
    report.method = prefilter_method_name(settings.method);
    if (settings.method == host::PrefilterMethod::chain) report.quality = settings.quality;
    report.sanitised = (*source)->sanitised;
    report.append(environment->report);
    report.append(filtered->report);
    return report;
}

int prefilter_verb(const PrefilterOptions& options) {
    const Outcome<Report> report = prefilter(options);
    if (!report) return fail(report.error().message);
    return options.json ? print(as_json(*report)) : SUCCEEDED;
}

} // namespace

void add_prefilter(CLI::App& program, int& status) {
    const auto options = std::make_shared<PrefilterOptions>();
    CLI::App* const verb =
        program.add_subcommand("prefilter", "writes an environment map averaged over Phong lobes");
    verb->add_option("ENV", options->environment, "environment map, OpenEXR or Radiance .hdr")
        ->required();
    verb->add_option("-o", options->path,
                     "file to write: .exr, where several exponents become parts named as n=16, or "
                     ".ktx2, where they become levels from the sharpest on")
        ->required()
        ->type_name("FILE");
    add_parsed(*verb, "--format", parse_map_format, &options->format, "NAME",
               "exr or ktx2; default: what FILE ends in");
    add_parsed(*verb, "--exponents", parse_exponents, &options->exponents, "X,X,...",
               "Phong exponents, from 0 to 1e6, one map each");
    verb->add_flag("--lambert", options->lambert, "the diffuse lobe, which is exponent 1");
    add_parsed(*verb, "--method", parse_prefilter_method, &options->method, "NAME",
               "chain (the prefilter, the default), importance or filtered-importance (the usual "
               "methods), or exact (integrates over every texel for every texel)");
    add_parsed(*verb, "--samples", parse_count, &options->samples, "N",
               "samples of a texel for the two importance methods, 1 to 65535; default: 64");
    add_parsed(*verb, "--quality", parse_quality, &options->quality, "NAME",
               "of the chain: fast, normal (the default) or high");
    add_tolerance(*verb, options->tolerance);
    add_parsed(*verb, "--layout", parse_layout, &options->layout, "NAME",
               "cube, the default, or latlong");
    add_parsed(*verb, "--face", parse_count, &options->face, "N",
               "texels of an edge of the cube map, of level 0 in KTX2; default: what lobes need");
    add_parsed(*verb, "--size", parse_size, &options->size, "WxH",
               "size of the latlong map; default: what the lobe needs");
    add_gpu_options(*verb, options->gpu);
    verb->add_flag("--json", options->json, "print one JSON object about what was done");
    verb->callback([options, &status] {
        const auto output = map_file(options->path, options->format);
        if (!output) throw CLI::ValidationError("-o", output.error().message);
        options->output = *output;
        check_usage(*options);
        status = prefilter_verb(*options);
    });
}

} // namespace lobelia::cli
