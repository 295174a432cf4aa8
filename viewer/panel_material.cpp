#include "panel.h"

#include <algorithm>

#include "presets.h"

namespace lobelia::cli {

namespace {

using Colour = std::array<float, 3>;

constexpr float END_OF_SLIDER = 10000.0f; // exponents beyond are typed
constexpr float LARGEST_EXPONENT = 1e6f;

const char* preset_text(void*, int index) {
    return PRESETS[index].name;
}

int preset_of(const Material& material) {
    for (int i = 0; i < PRESET_COUNT; ++i) {
        const Material& preset = PRESETS[i].material;
        if (preset.diffuse == material.diffuse && preset.specular == material.specular &&
            preset.exponent == material.exponent)
            return i;
    }
    return -1;
}

// What kd leaves to ks, and the other way round.
float limit(float other, bool energy_gain) {
    return energy_gain ? 1.0f : std::max(1.0f - other, 0.0f);
}

} // namespace

void Panel::draw_reflectance(ViewState& state, const char* name, Colour& colour,
                             const Colour& other, const Colour& reset) {
    widgets_.row(name);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float swatch = ImGui::GetFrameHeight();
    const float width = (ImGui::GetContentRegionAvail().x - swatch - 3.0f * gap) / 3.0f;
    const Colour before = colour;
    const char* const channels[] = {"r", "g", "b"};
    for (std::size_t c = 0; c < 3; ++c) {
        ImGui::SetNextItemWidth(width);
        const std::string control = std::string(name) + "." + channels[c];
        if (widgets_.slider(control.c_str(), colour[c], 0.0f, 1.0f, "%.2f", reset[c]) && together_)
            colour.fill(colour[c]);
        ImGui::SameLine(0.0f, gap);
    }
    ImGui::PushID(name);
    if (ImGui::ColorButton("##swatch", ImVec4(colour[0], colour[1], colour[2], 1.0f),
                           ImGuiColorEditFlags_NoTooltip, ImVec2(swatch, swatch)))
        ImGui::OpenPopup("picker");
    if (ImGui::BeginPopup("picker")) {
        ImGui::ColorPicker3("##colour", colour.data(),
                            ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoSidePreview);
        ImGui::EndPopup();
    }
    ImGui::PopID();
    if (colour == before) return;
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = std::clamp(colour[c], 0.0f, limit(other[c], state.energy_gain));
    if (together_) colour.fill(*std::min_element(colour.begin(), colour.end()));
}

void Panel::draw_material(ViewState& state) {
    Material& material = state.material();
    widgets_.heading("Material");
    widgets_.row("Preset");
    int preset = preset_of(material);
    if (widgets_.combo("preset", preset, PRESET_COUNT, preset_text, nullptr))
        material = PRESETS[preset].material;
    const Material& reset = start_.material();
    draw_reflectance(state, "kd", material.diffuse, material.specular, reset.diffuse);
    draw_reflectance(state, "ks", material.specular, material.diffuse, reset.specular);

    float most = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, material.diffuse[c] + material.specular[c]);
    widgets_.row("kd + ks");
    char text[48];
    std::snprintf(text, sizeof text, "%.2f of 1%s", double(most),
                  most > 1.0f + 1e-6f ? ", gains" : "");
    const float as_one = 5.2f * ImGui::GetFontSize();
    ImGui::ProgressBar(std::min(most, 1.0f),
                       ImVec2(ImGui::GetContentRegionAvail().x - as_one, 0.0f), text);
    ImGui::SameLine();
    widgets_.checkbox("together", "as grey", together_);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the channels move as one");

    widgets_.row("n");
    const float typed = 4.6f * ImGui::GetFontSize();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - typed - gap);
    widgets_.log_slider("n", material.exponent, END_OF_SLIDER, "%.4g", reset.exponent);
    ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(-1.0f);
    float exponent = material.exponent;
    if (ImGui::InputFloat("##exactly", &exponent, 0.0f, 0.0f, "%.6g",
                          ImGuiInputTextFlags_EnterReturnsTrue) &&
        exponent >= 0.0f) // also not NaN
        material.exponent = std::min(exponent, LARGEST_EXPONENT);
    widgets_.mark("n.exactly");

    widgets_.row("Lobes");
    int lobes = int(state.lobes);
    if (widgets_.choice("lobes", lobes, {"both", "diffuse", "specular"}))
        state.lobes = Lobes(lobes);
}

} // namespace lobelia::cli
