#include <memory>

#include "messages.h"
#include "numbers.h"
#include "parsed_option.h"
#include "sphere_options.h"
#include "verbs.h"
#include "viewer.h"

namespace lobelia::cli {

namespace {

struct ViewOptions {
    std::string environment; // empty: built-in
    SphereOptions sphere;
    float exposure = 0.0f;
    GpuChoice gpu;
    bool json = false;
};

ViewerStart start_of(const ViewOptions& options) {
    const SphereOptions& sphere = options.sphere;
    const ViewState standard;
    ViewerStart start{.state = {.environment = options.environment,
                                .face = sphere.face,
                                .settings = settings_of(sphere),
                                .background = sphere.no_background ? Background::off
                                              : sphere.blur        ? Background::blurred
                                                                   : Background::sharp,
                                .blur = sphere.blur.value_or(standard.blur),
                                .rotation = sphere.rotation,
                                .exposure = options.exposure,
                                .energy_gain = sphere.allow_energy_gain},
                      .size = {sphere.width, sphere.height},
                      .gpu = options.gpu,
                      .json = options.json};
    // The background is made beside the pictures, for both methods.
    start.state.settings.background_exponent = standard.settings.background_exponent;
    return start;
}

int view_verb(const ViewOptions& options) {
    const ViewerStart start = start_of(options);
    if (const auto refused = host::check_material(start.state.material(), start.state.energy_gain))
        return fail(refused->message);
    const auto ended = run_viewer(start);
    return ended ? SUCCEEDED : fail(ended.error().message);
}

} // namespace

void add_view(CLI::App& program, int& status) {
    const auto options = std::make_shared<ViewOptions>();
    options->sphere.width = 1280;
    options->sphere.height = 720;
    CLI::App* const verb =
        program.add_subcommand("view", "shows the sphere in a window, to edit it (F1 there: help)");
    verb->add_option("ENV", options->environment,
                     "environment map, OpenEXR or Radiance .hdr; default: a built-in one");
    add_sphere_options(*verb, options->sphere);
    add_parsed(*verb, "--exposure", parse_number, &options->exposure, "EV", "in stops; default 0");
    add_gpu_options(*verb, options->gpu);
    verb->add_flag("--json", options->json,
                   "print one JSON object a line for each frame: what it showed and cost");
    verb->callback([options, &status] {
        check_usage(options->sphere);
        status = view_verb(*options);
    });
}

} // namespace lobelia::cli
