#include <cmath>
#include <filesystem>
#include <memory>

#include <lobelia/host/write.h>

#include "gallery_animation.h"
#include "gallery_sheet.h"
#include "gpu_choice.h"
#include "messages.h"
#include "program.h"
#include "verbs.h"

namespace lobelia::cli {

using host::Failure;
using host::Outcome;

namespace {

constexpr const char* STYLE = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60em; margin: 0 auto; padding: 1em;
       color: #222; background: #fff }
h1, h2 { line-height: 1.2 }
img { max-width: 100%; height: auto }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: .2em .8em; text-align: right; border-bottom: 1px solid #ddd }
th:first-child, td:first-child { text-align: left }
)";

struct GalleryOptions {
    std::string folder;
    GpuChoice gpu;
};

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value < 10.0 ? "%.1f" : "%.0f", value);
    return text;
}

std::string time_row(const std::string& what, const host::Frames::Time& time) {
    return "<tr><td>" + what + "</td><td>" + rounded(time.cpu_ms) + "</td><td>" +
           rounded(time.wall_ms) + "</td><td>" + rounded(1000.0 / time.wall_ms) + "</td></tr>\n";
}

std::string page(const std::string& device, const std::vector<GalleryFigure>& figures,
                 const std::vector<GalleryAnimation>& animations) {
    std::string body =
        "<h1>The figures of Kurt 2019, anew</h1>\n<p>\"Real-Time Shading with Phong BRDF Model\", "
        "by "
        "lobelia's default method, by the paper's (kurt2019) and by the reference, which "
        "integrates "
        "over every texel. Beneath each: the root mean square of |value - exact| / (|exact| + 1e-3 "
        "mean) over the pixels that the sphere covers. The spheres' light has " +
        std::to_string(GALLERY_FACE) + " texels a face. Drawn on " + device + ".</p>\n";
    for (const GalleryFigure& figure : figures)
        body += "<h2>" + figure.title + "</h2>\n<p>" + figure.text + "</p>\n<p><img src=\"" +
                figure.name + ".png\" alt=\"" + figure.title + "\"></p>\n";
    body +=
        "<h2>Figure 5 in motion</h2>\n<p>512 x 512 pixels, kd 0.3, ks 0.6, n = 4.8; the light of "
        "every frame is prefiltered in that frame, and nothing is kept from the one before. "
        "(Turning alone would need no prefilter.) Medians over the frames; a frame is one "
        "submission that is waited for. The paper states about 60 frames per second, of its "
        "method, on a Quadro K4200.</p>\n<p>";
    for (const GalleryAnimation& one : animations)
        body += "<img src=\"" + one.name + ".gif\" alt=\"" + one.text + "\">\n";
    body +=
        "</p>\n<table>\n<tr><th></th><th>CPU ms</th><th>ms</th><th>frames per second</th></tr>\n";
    body += time_row("still: the sphere alone", animations.front().times.still);
    for (const GalleryAnimation& one : animations)
        body += time_row(one.text + ": prefilter and sphere", one.times.changing);
    body += "<tr><td>the paper</td><td></td><td></td><td>60</td></tr>\n</table>\n";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>Lobelia: the figures of Kurt 2019</title>\n<style>" +
           std::string(STYLE) + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

Outcome<Done> make_gallery(const GalleryOptions& options) {
    for (const char* const program : {"montage", "convert"})
        if (!has_program(program))
            return Failure{std::string("there is no ") + program +
                           " to compose pictures with, install ImageMagick (Debian: imagemagick)"};
    std::error_code error;
    std::filesystem::create_directories(options.folder + "/pictures", error);
    if (error)
        return Failure{options.folder + ": cannot be made a folder (" + error.message() +
                       "), give another to -o"};
    ProgressLine progress;
    auto gpu = start_gpu(options.gpu);
    if (!gpu) return gpu.error();
    const auto lights = gallery_lights(*gpu, progress);
    if (!lights) return lights.error();
    const auto animations = gallery_animations(*gpu, *lights, options.folder, progress);
    if (!animations) return animations.error();
    const auto figures = gallery_figures(*gpu, *lights, progress);
    if (!figures) return figures.error();
    progress.begin("composing");
    for (const GalleryFigure& figure : *figures)
        if (const auto written = write_sheet(options.folder, figure); !written)
            return written.error();
    const std::string text = page(gpu->description().name, *figures, *animations);
    return host::replace_file(options.folder + "/index.html", std::as_bytes(std::span(text)));
}

} // namespace

void add_gallery(CLI::App& program, int& status) {
    const auto options = std::make_shared<GalleryOptions>();
    CLI::App* const verb = program.add_subcommand(
        "gallery", "renders the figures of the paper that the material comes from");
    verb->add_option("-o", options->folder, "folder for the figures and index.html")
        ->required()
        ->type_name("DIR");
    add_gpu_options(*verb, options->gpu);
    verb->callback([options, &status] {
        const auto made = make_gallery(*options);
        status = made ? SUCCEEDED : fail(made.error().message);
    });
}

} // namespace lobelia::cli
