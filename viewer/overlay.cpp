#include "overlay.h"

#include <cmath>
#include <iterator>

#include "sphere_options.h"

namespace lobelia::cli {

namespace {

constexpr ImU32 LIGHT = IM_COL32(235, 235, 235, 255);
constexpr ImU32 SHADE = IM_COL32(12, 12, 12, 200);

#define STOP(r, g, b)                                                                              \
    { r, g, b, 1.0f }
constexpr float FALSE_COLOURS[][4] = {
#include "false_colours.inc"
};
#undef STOP

ImU32 packed(const float (&colour)[4]) {
    return ImGui::ColorConvertFloat4ToU32(ImVec4(colour[0], colour[1], colour[2], 1.0f));
}

// Text on a dark plate; `align` 0 puts its left edge at x, 1 its right one.
void draw_label(ImDrawList& list, const char* text, float x, float y, float align) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float pad = 0.35f * ImGui::GetFontSize();
    const ImVec2 low(std::round(x - align * (size.x + 2.0f * pad)), y);
    list.AddRectFilled(low, ImVec2(low.x + size.x + 2.0f * pad, low.y + size.y + pad), SHADE, 3.0f);
    list.AddText(ImVec2(low.x + pad, low.y + 0.5f * pad), LIGHT, text);
}

void draw_divider(ImDrawList& list, const ViewState& state, ImVec2 window) {
    const float x = std::round(state.divider * window.x);
    const float gap = 0.6f * ImGui::GetFontSize();
    list.AddLine(ImVec2(x, 0.0f), ImVec2(x, window.y), SHADE, 3.0f);
    list.AddLine(ImVec2(x, 0.0f), ImVec2(x, window.y), LIGHT, 1.0f);
    const float size = 0.45f * ImGui::GetFontSize();
    for (const float side : {-1.0f, 1.0f}) {
        const float from = x + side * 0.4f * size, to = x + side * 1.4f * size;
        list.AddTriangleFilled(ImVec2(from, 0.5f * window.y - size),
                               ImVec2(from, 0.5f * window.y + size), ImVec2(to, 0.5f * window.y),
                               LIGHT);
    }
    draw_label(list, method_name(state.settings.method), x - gap, gap, 1.0f);
    draw_label(list, method_name(state.other), x + gap, gap, 0.0f);
}

void draw_legend(ImDrawList& list, ImVec2 window) {
    const float text = ImGui::GetFontSize();
    const float width = 20.0f * text, height = 0.8f * text;
    const ImVec2 low(window.x - width - 2.0f * text, window.y - 3.2f * text);
    list.AddRectFilled(ImVec2(low.x - text, low.y - 1.6f * text),
                       ImVec2(low.x + width + text, low.y + height + 1.7f * text), SHADE, 3.0f);
    list.AddText(ImVec2(low.x, low.y - 1.35f * text), LIGHT, "error relative to the reference");
    constexpr int STEPS = int(std::size(FALSE_COLOURS)) - 1;
    for (int i = 0; i < STEPS; ++i) {
        const ImU32 from = packed(FALSE_COLOURS[i]), to = packed(FALSE_COLOURS[i + 1]);
        list.AddRectFilledMultiColor(ImVec2(low.x + width * float(i) / STEPS, low.y),
                                     ImVec2(low.x + width * float(i + 1) / STEPS, low.y + height),
                                     from, to, to, from);
    }
    const char* const marks[] = {"1e-4", "1e-3", "1e-2", "0.1", "1"};
    for (int i = 0; i < int(std::size(marks)); ++i) {
        const float x = low.x + width * float(i) / float(std::size(marks) - 1);
        const float half = 0.5f * ImGui::CalcTextSize(marks[i]).x;
        list.AddText(ImVec2(std::round(x - half), low.y + height + 0.2f * text), LIGHT, marks[i]);
    }
}

void draw_mark(ImDrawList& list, const Pick& pick) {
    const ImVec2 at(float(pick.x) + 0.5f, float(pick.y) + 0.5f);
    const float radius = 0.5f * ImGui::GetFontSize();
    list.AddCircle(at, radius + 1.0f, SHADE, 0, 3.0f);
    list.AddCircle(at, radius, LIGHT, 0, 1.5f);
}

struct HelpLine {
    const char* keys;
    const char* does;
};
constexpr HelpLine HELP[] = {
    {"drag", "orbit"},
    {"wheel, two fingers", "zoom"},
    {"Shift + drag", "turn the light"},
    {"double-click, Home", "camera as it was"},
    {"right click", "what a pixel shows, and should"},
    {"drop a file", "light from an .exr or .hdr panorama"},
    {"Ctrl + click", "sets a slider back"},
    {"", ""},
    {"Tab", "hide or show the panel"},
    {"S, drag the line", "two methods side by side"},
    {"F", "flip between them"},
    {"E", "errors as false colour"},
    {"1  2  3", "both lobes, diffuse, specular"},
    {"B", "background sharp, blurred, off"},
    {"T", "the light turns by itself"},
    {"P  X  C", "save PNG, save EXR, copy the command"},
    {"Ctrl  +  -  0", "larger, smaller text"},
    {"Ctrl + arrows", "orbit; page up, down: zoom"},
    {"arrows, Space, Enter", "through the panel's controls"},
    {"Esc, Ctrl + Q", "close this, quit"},
};

void draw_help(ImVec2 window) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * window.x, 0.5f * window.y), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::Begin("Help", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav);
    for (const HelpLine& line : HELP) {
        ImGui::TextUnformatted(line.keys);
        ImGui::SameLine(12.0f * ImGui::GetFontSize());
        ImGui::TextDisabled("%s", line.does);
    }
    ImGui::End();
}

} // namespace

void draw_overlay(const ViewState& state, const Status& status) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    if (state.split) draw_divider(list, state, window);
    if (state.errors) draw_legend(list, window);
    if (status.pick) draw_mark(list, *status.pick);
    if (state.help) draw_help(window);
}

} // namespace lobelia::cli
