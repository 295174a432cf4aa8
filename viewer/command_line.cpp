#include "command_line.h"

#include "numbers.h"
#include "quality.h"
#include "sphere_options.h"

namespace lobelia::cli {

namespace {

// As one word of a POSIX shell.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string three(const std::array<float, 3>& a) {
    return number_text(a[0]) + "," + number_text(a[1]) + "," + number_text(a[2]);
}

} // namespace

std::string command_line(const ViewState& state, VkExtent2D size) {
    const SphereView view = shown_view(state, size);
    const Camera standard;
    std::string command = "lobelia render";
    const auto add = [&](const std::string& option) { command += " " + option; };
    if (!state.environment.empty()) add(quoted(state.environment));
    add("--kd " + three(view.material.diffuse));
    add("--ks " + three(view.material.specular));
    add("-n " + number_text(view.material.exponent));
    if (state.energy_gain) add("--allow-energy-gain");
    add(std::string("--method ") + method_name(state.settings.method));
    add(std::string("--quality ") + quality_name(state.settings.quality));
    if (state.settings.method == SphereMethod::importance)
        add("--samples " + std::to_string(state.settings.samples));
    if (state.face) add("--face " + std::to_string(state.face));
    if (view.camera.eye != standard.eye) add("--eye " + three(view.camera.eye));
    if (view.camera.target != standard.target) add("--target " + three(view.camera.target));
    if (view.camera.up != standard.up) add("--up " + three(view.camera.up));
    if (view.camera.vertical_field_of_view != standard.vertical_field_of_view)
        add("--fov " + number_text(view.camera.vertical_field_of_view));
    if (state.rotation != 0.0f) add("--rotate " + number_text(state.rotation));
    if (state.exposure != 0.0f) add("--exposure " + number_text(state.exposure));
    if (state.background == Background::off) add("--no-background");
    if (state.background == Background::blurred) add("--blur " + number_text(state.blur));
    add("--size " + std::to_string(size.width) + "x" + std::to_string(size.height));
    return command;
}

host::Metadata metadata_of(const ViewState& state, VkExtent2D size) {
    const SphereView view = shown_view(state, size);
    host::Metadata metadata{{"lobelia:method", method_name(state.settings.method)},
                            {"lobelia:kd", three(view.material.diffuse)},
                            {"lobelia:ks", three(view.material.specular)},
                            {"lobelia:n", number_text(view.material.exponent)},
                            {"lobelia:command", command_line(state, size)}};
    if (state.split) {
        metadata.emplace_back("lobelia:right method", method_name(state.other));
        metadata.emplace_back("lobelia:divider", number_text(state.divider));
    }
    if (state.errors) metadata.emplace_back("lobelia:shows", "errors");
    return metadata;
}

} // namespace lobelia::cli
