#include <memory>

#include <lobelia/host/write.h>

#include "environment.h"
#include "gpu_choice.h"
#include "messages.h"
#include "numbers.h"
#include "outputs.h"
#include "parsed_option.h"
#include "report.h"
#include "sphere_options.h"
#include "tolerance.h"
#include "verbs.h"

namespace lobelia::cli {

namespace {

struct RenderOptions {
    std::string environment; // empty: built-in
    SphereOptions sphere;
    float exposure = 0.0f;
    std::vector<OutputFile> outputs;
    GpuChoice gpu;
    bool json = false;
};

std::string colour_text(const std::array<float, 3>& colour) {
    return number_text(colour[0]) + "," + number_text(colour[1]) + "," + number_text(colour[2]);
}

host::Metadata metadata_of(const host::RenderSettings& settings) {
    const Material& material = settings.view.material;
    host::Metadata metadata{{"lobelia:method", method_name(settings.method)},
                            {"lobelia:kd", colour_text(material.diffuse)},
                            {"lobelia:ks", colour_text(material.specular)},
                            {"lobelia:n", number_text(material.exponent)}};
    if (settings.method == SphereMethod::importance)
        metadata.emplace_back("lobelia:samples", std::to_string(settings.samples));
    return metadata;
}

// Refuses what is not valid; what is only allowed gets its warning.
Outcome<Done> check(const RenderOptions& options, const Material& material) {
    const bool allowed = options.sphere.allow_energy_gain;
    if (const auto refused = host::check_material(material, allowed)) return *refused;
    if (allowed)
        if (const auto gain = host::check_material(material, false))
            say("warning: " + gain->message);
    return check_outputs(options.outputs);
}

// With a background every pixel is covered by something; its alpha says only how much by the
// sphere.
host::Image made_opaque(host::Image picture) {
    for (std::size_t i = 3; i < picture.texels.size(); i += 4) picture.texels[i] = 1.0f;
    return picture;
}

Outcome<Done> write_picture(const OutputFile& file, const host::Image& picture,
                            const host::RenderSettings& settings, float exposure) {
    if (file.kind == FileKind::exr) {
        const host::Part part{.image = &picture};
        return host::write_exr(file.path, {&part, 1}, host::Content::picture,
                               metadata_of(settings));
    }
    return settings.view.background ? host::write_png(file.path, made_opaque(picture), exposure)
                                    : host::write_png(file.path, picture, exposure);
}

Outcome<Report> render(const RenderOptions& options) {
    Report report;
    host::RenderSettings settings = settings_of(options.sphere);
    if (const auto valid = check(options, settings.view.material); !valid) return valid.error();

    ProgressLine progress;
    const auto source = read_source(options.environment, progress);
    if (!source) return source.error();
    auto gpu = start_gpu(options.gpu);
    if (!gpu) return gpu.error();
    if (const auto met = meet(options.sphere.tolerance, *gpu, shape_of(*source), settings); !met)
        return met.error();
    const auto environment =
        upload_source(*gpu, *source, options.sphere.face, settings.quality, progress);
    if (!environment) return environment.error();

    progress.begin("rendering");
    const auto rendering = host::render(*gpu, *environment, settings, progress.listener());
    if (!rendering) return rendering.error();

    progress.begin("writing");
    const auto written = write_outputs(options.outputs, [&](const OutputFile& file) {
        return write_picture(file, rendering->picture, settings, options.exposure);
    });
    if (!written) return written.error();

    report.gpu = gpu->description();
    report.method = method_name(settings.method);
    if (rendering->report.suns) report.quality = settings.quality;
    if (*source) report.sanitised = (*source)->sanitised;
    report.append(environment->report);
    report.append(rendering->report);
    return report;
}

int render_verb(const RenderOptions& options) {
    const Outcome<Report> report = render(options);
    if (!report) return fail(report.error().message);
    return options.json ? print(as_json(*report)) : SUCCEEDED;
}

void add_outputs(CLI::App& verb, RenderOptions& options) {
    const auto read = [&options](const std::vector<std::string>& paths) {
        for (const std::string& path : paths) {
            Outcome<OutputFile> output = parse_output(path);
            if (!output) throw CLI::ValidationError("-o", output.error().message);
            options.outputs.push_back(std::move(*output));
        }
    };
    verb.add_option_function<std::vector<std::string>>(
            "-o", read,
            "file to write, .exr or .png, may be given several times; default sphere.exr and "
            "sphere.png")
        ->type_name("FILE")
        ->allow_extra_args(false);
}

} // namespace

void add_render(CLI::App& program, int& status) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* const verb = program.add_subcommand("render", "shades the sphere offscreen");
    verb->add_option("ENV", options->environment,
                     "environment map, OpenEXR or Radiance .hdr; default: a built-in one");
    add_outputs(*verb, *options);
    add_sphere_options(*verb, options->sphere);
    add_tolerance(*verb, options->sphere.tolerance);
    add_parsed(*verb, "--exposure", parse_number, &options->exposure, "EV",
               "of the PNG, in stops; default 0");
    add_gpu_options(*verb, options->gpu);
    verb->add_flag("--json", options->json, "print one JSON object about what was done");
    verb->callback([options, &status] {
        if (options->outputs.empty())
            options->outputs = {{"sphere.exr", FileKind::exr}, {"sphere.png", FileKind::png}};
        check_usage(options->sphere);
        status = render_verb(*options);
    });
}

} // namespace lobelia::cli
