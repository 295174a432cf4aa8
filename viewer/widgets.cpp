#include "widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lobelia::cli {

namespace {

// Ctrl sets back, whatever the mouse says meanwhile.
bool is_reset() {
    return ImGui::IsItemActive() && ImGui::GetIO().KeyCtrl &&
           ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

constexpr ImGuiSliderFlags SLIDER =
    ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;

} // namespace

void Widgets::heading(const char* text) const {
    ImGui::Dummy(ImVec2(0.0f, 0.1f * ImGui::GetTextLineHeight()));
    ImGui::TextDisabled("%s", text);
    ImGui::Separator();
}

void Widgets::row(const char* label) const {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(5.6f * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-1.0f);
}

void Widgets::mark(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    places_[name] = {low.x, low.y, high.x - low.x, high.y - low.y};
}

bool Widgets::slider(const char* name, float& value, float least, float most, const char* format,
                     float reset) {
    const float before = value;
    ImGui::PushID(name);
    ImGui::SliderFloat("##slider", &value, least, most, format, SLIDER);
    ImGui::PopID();
    if (is_reset()) value = reset;
    mark(name);
    return value != before;
}

bool Widgets::log_slider(const char* name, float& value, float most, const char* format,
                         float reset) {
    char text[32];
    std::snprintf(text, sizeof text, format, double(value));
    for (char* c = text; *c; ++c)
        if (*c == '%') *c = ' '; // ImGui takes it as a format
    const float end = std::log1p(most);
    const float before = std::min(std::log1p(value) / end, 1.0f);
    float place = before;
    ImGui::PushID(name);
    ImGui::SliderFloat("##slider", &place, 0.0f, 1.0f, text, SLIDER);
    ImGui::PopID();
    const float old = value;
    if (place != before) value = std::expm1(place * end);
    if (is_reset()) value = reset;
    mark(name);
    return value != old;
}

bool Widgets::button(const char* name, const char* text, float width) {
    const bool pressed = ImGui::Button(text, ImVec2(width, 0.0f));
    mark(name);
    return pressed;
}

bool Widgets::checkbox(const char* name, const char* text, bool& value) {
    const bool changed = ImGui::Checkbox(text, &value);
    mark(name);
    return changed;
}

bool Widgets::combo(const char* name, int& chosen, int count, const char* (*text)(void*, int),
                    void* texts) {
    const int before = chosen;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    places_[name] = {at.x, at.y, ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
    ImGui::PushID(name);
    const bool is_one = chosen >= 0 && chosen < count;
    if (ImGui::BeginCombo("##combo", is_one ? text(texts, chosen) : "",
                          ImGuiComboFlags_HeightLarge)) {
        for (int i = 0; i < count; ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(text(texts, i), i == before)) chosen = i;
            ImGui::PopID();
            // Before it has come to rest the list is not where it will be.
            if (!ImGui::IsWindowAppearing()) mark(std::string(name) + "." + text(texts, i));
            if (i == before) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return chosen != before;
}

bool Widgets::choice(const char* name, int& chosen, std::initializer_list<const char*> texts) {
    const int before = chosen;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float count = float(texts.size());
    const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count;
    int i = 0;
    for (const char* const text : texts) {
        if (i > 0) ImGui::SameLine(0.0f, gap);
        const bool is_chosen = i == before;
        if (is_chosen)
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (button((std::string(name) + "." + text).c_str(), text, width)) chosen = i;
        if (is_chosen) ImGui::PopStyleColor();
        ++i;
    }
    return chosen != before;
}

} // namespace lobelia::cli
