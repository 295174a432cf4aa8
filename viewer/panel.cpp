#include "panel.h"

#include "environment_list.h"
#include "sphere_options.h"

namespace lobelia::cli {

namespace {

constexpr float WIDTH = 20.5f; // in letters' heights

const char* method_text(void* methods, int index) {
    return (*static_cast<std::vector<host::RenderMethod>*>(methods))[std::size_t(index)].name;
}

const char* environment_text(void* environments, int index) {
    const auto& paths = *static_cast<std::vector<std::string>*>(environments);
    const std::string& path = paths[std::size_t(index)];
    return path.empty() ? "built-in sky" : path.c_str() + (path.find_last_of('/') + 1);
}

bool choose_method(Widgets& widgets, const char* name, SphereMethod& method) {
    std::vector<host::RenderMethod> methods = host::render_methods();
    int chosen = 0;
    for (std::size_t i = 0; i < methods.size(); ++i)
        if (methods[i].method == method) chosen = int(i);
    const bool changed = widgets.combo(name, chosen, int(methods.size()), method_text, &methods);
    if (changed) method = methods[std::size_t(chosen)].method;
    const bool is_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    if (!is_open && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", methods[std::size_t(chosen)].what);
    return changed;
}

} // namespace

void Panel::list_environments(const std::string& current) {
    environments_ = list_environment_files(current);
}

void Panel::draw(ViewState& state, const Status& status, Requests& requests) {
    widgets_.forget();
    if (!state.panel) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::SetNextWindowSize(ImVec2(WIDTH * ImGui::GetFontSize(), window.y));
    ImGui::Begin("Lobelia", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_material(state);
    draw_light(state, requests);
    draw_method(state);
    draw_output(requests);
    draw_status(status);
    ImGui::End();
}

void Panel::draw_light(ViewState& state, Requests& requests) {
    widgets_.heading("Light");
    widgets_.row("From");
    int chosen = -1;
    for (std::size_t i = 0; i < environments_.size(); ++i)
        if (environments_[i] == state.environment) chosen = int(i);
    if (widgets_.combo("environment", chosen, int(environments_.size()), environment_text,
                       &environments_))
        requests.open = environments_[std::size_t(chosen)];
    widgets_.row("");
    if (ImGui::InputTextWithHint("##path", "path, or drop a file here", path_, sizeof path_,
                                 ImGuiInputTextFlags_EnterReturnsTrue) &&
        path_[0]) {
        requests.open = path_;
        path_[0] = '\0';
    }
    widgets_.mark("path");
    widgets_.row("Rotation");
    bool turns = state.turning != 0.0f;
    if (widgets_.checkbox("turn", "##turn", turns)) state.turning = turns ? DEGREES_A_SECOND : 0.0f;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the light turns by itself");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    widgets_.slider("rotation", state.rotation, -180.0f, 180.0f, "%.1f\xC2\xB0", start_.rotation);
    widgets_.row("Exposure");
    widgets_.slider("exposure", state.exposure, -8.0f, 8.0f, "%+.2f EV", start_.exposure);
    widgets_.row("Behind");
    int background = int(state.background);
    if (widgets_.choice("background", background, {"sharp", "blurred", "off"}))
        state.background = Background(background);
    if (state.background == Background::blurred) {
        widgets_.row("  by n");
        widgets_.log_slider("blur", state.blur, 1000.0f, "%.3g", start_.blur);
    }
}

void Panel::draw_method(ViewState& state) {
    widgets_.heading("Method");
    widgets_.row("Method");
    choose_method(widgets_, "method", state.settings.method);
    widgets_.row("Quality");
    int quality = int(state.settings.quality);
    if (widgets_.choice("quality", quality, {"fast", "normal", "high"}))
        state.settings.quality = Quality(quality);
    widgets_.row("Beside");
    widgets_.checkbox("split", "##split", state.split);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    if (choose_method(widgets_, "other", state.other)) state.split = true;
    widgets_.row("");
    widgets_.checkbox("errors", "errors as false colour", state.errors);
}

void Panel::draw_output(Requests& requests) {
    widgets_.heading("Out");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
    requests.save_png |= widgets_.button("png", "Save PNG", width);
    ImGui::SameLine(0.0f, gap);
    requests.save_exr |= widgets_.button("exr", "Save EXR", width);
    ImGui::SameLine(0.0f, gap);
    requests.copy_command |= widgets_.button("copy", "Command", width);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("copies the command line that renders what is seen");
}

} // namespace lobelia::cli
