#include "sphere_options.h"

#include <cmath>
#include <numbers>

#include "numbers.h"
#include "parsed_option.h"
#include "quality.h"

namespace lobelia::cli {

namespace {

using Colour = std::array<float, 3>;

constexpr Colour DEFAULT_DIFFUSE{0.3f, 0.3f, 0.3f};
constexpr Colour DEFAULT_SPECULAR{0.6f, 0.6f, 0.6f};

Outcome<SphereMethod> parse_method(std::string_view text) {
    std::string names;
    for (const host::RenderMethod& known : host::render_methods()) {
        if (text == known.name) return known.method;
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    return host::Failure{"\"" + std::string(text) + "\" is no method; there are " + names};
}

std::string method_help() {
    std::string help = "default " + std::string(method_name(host::method_for(Quality::normal))) +
                       ", of fast " + method_name(host::method_for(Quality::fast)) +
                       " and of high " + method_name(host::method_for(Quality::high));
    for (const host::RenderMethod& known : host::render_methods())
        help += "; " + std::string(known.name) + ": " + known.what;
    return help;
}

Material material_of(const SphereOptions& options) {
    const bool neither = !options.diffuse && !options.specular;
    return {options.diffuse.value_or(neither ? DEFAULT_DIFFUSE : Colour{}),
            options.specular.value_or(neither ? DEFAULT_SPECULAR : Colour{}), options.exponent};
}

void add_material(CLI::App& verb, SphereOptions& options) {
    add_parsed(verb, "--kd", parse_colour, &options.diffuse, "V|R,G,B",
               "diffuse reflectance; default 0.3, or 0 where only --ks is given");
    add_parsed(verb, "--ks", parse_colour, &options.specular, "V|R,G,B",
               "specular reflectance; default 0.6, or 0 where only --kd is given");
    add_parsed(verb, "-n", parse_exponent, &options.exponent, "X",
               "Phong exponent, from 0 to 1e6; default 64");
    verb.add_flag("--allow-energy-gain", options.allow_energy_gain,
                  "let kd + ks exceed 1, with a warning");
}

void add_camera(CLI::App& verb, SphereOptions& options) {
    add_parsed(
        verb, "--eye", parse_vector, &options.camera.eye, "x,y,z",
        "where the camera is; default 0,0,4 (the sphere has radius 1 and lies at the origin)");
    add_parsed(verb, "--target", parse_vector, &options.camera.target, "x,y,z",
               "what it looks at; default 0,0,0");
    add_parsed(verb, "--up", parse_vector, &options.camera.up, "x,y,z",
               "what is up in the picture; default 0,1,0");
    add_parsed(verb, "--fov", parse_number, &options.camera.vertical_field_of_view, "DEG",
               "vertical field of view; default 30");
    add_parsed(
        verb, "--size", parse_size,
        [&options](Size size) {
            options.width = size.width;
            options.height = size.height;
        },
        "WxH",
        "size of the picture; default " + std::to_string(options.width) + "x" +
            std::to_string(options.height));
}

void add_environment(CLI::App& verb, SphereOptions& options) {
    add_parsed(verb, "--rotate", parse_number, &options.rotation, "DEG",
               "turn the environment about +Y, counter-clockwise seen from above; default 0");
    verb.add_flag("--no-background", options.no_background,
                  "leave transparent black where the sphere is not");
    add_parsed(verb, "--blur", parse_exponent, &options.blur, "X",
               "blur the background by a lobe of that exponent, from 0 to 1e6; default: sharp");
    add_parsed(verb, "--face", parse_count, &options.face, "N",
               "texels of an edge of the environment's cube map; default: the next power of two "
               "from a quarter of the panorama's width");
}

} // namespace

void add_sphere_options(CLI::App& verb, SphereOptions& options) {
    add_material(verb, options);
    add_camera(verb, options);
    add_environment(verb, options);
    add_parsed(verb, "--method", parse_method, &options.method, "NAME", method_help());
    add_parsed(verb, "--samples", parse_count, &options.samples, "N",
               "fetches of each lobe by --method importance, 1 to 1024; default 64");
    add_parsed(verb, "--quality", parse_quality, &options.quality, "NAME",
               "of the maps: fast, normal (the default) or high");
}

void check_usage(const SphereOptions& options) {
    if (options.tolerance && (options.method || options.quality || options.face))
        throw CLI::ValidationError("--tolerance",
                                   "chooses --method, --quality and --face; leave those out");
    if (options.blur && options.no_background)
        throw CLI::ValidationError("--blur", "needs a background; leave --no-background out");
    if (options.samples && options.method != SphereMethod::importance)
        throw CLI::ValidationError("--samples", "is for --method importance");
}

host::RenderSettings settings_of(const SphereOptions& options) {
    // Whole turns change nothing, and would cost the radians their digits.
    const double turn = std::fmod(double(options.rotation), 360.0);
    const Quality quality = options.quality.value_or(Quality::normal);
    return {.view = {.camera = options.camera,
                     .material = material_of(options),
                     .environment_rotation = float(turn * std::numbers::pi / 180.0),
                     .background = !options.no_background,
                     .width = options.width,
                     .height = options.height},
            .method = options.method.value_or(host::method_for(quality)),
            .quality = quality,
            .samples = options.samples.value_or(host::RenderSettings{}.samples),
            .background_exponent =
                options.blur.value_or(host::RenderSettings{}.background_exponent)};
}

const char* method_name(SphereMethod method) {
    for (const host::RenderMethod& known : host::render_methods())
        if (known.method == method) return known.name;
    return "";
}

} // namespace lobelia::cli
