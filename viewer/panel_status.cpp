#include "panel.h"

#include <algorithm>

namespace lobelia::cli {

namespace {

struct PassTime {
    std::string name;
    int count = 0;
    double milliseconds = 0.0;
};

// Passes of one name are one line.
std::vector<PassTime> times_of(const FrameWork& work) {
    std::vector<PassTime> times;
    for (const host::PassReport& pass : work) {
        const auto found = std::find_if(times.begin(), times.end(), [&](const PassTime& time) {
            return time.name == pass.name;
        });
        PassTime& time = found == times.end() ? times.emplace_back(PassTime{pass.name}) : *found;
        ++time.count;
        time.milliseconds += pass.gpu_ms.value_or(0.0);
    }
    return times;
}

std::string colour_text(const std::array<float, 3>& colour) {
    char text[64];
    std::snprintf(text, sizeof text, "%.4g  %.4g  %.4g", double(colour[0]), double(colour[1]),
                  double(colour[2]));
    return text;
}

void draw_pick(const Widgets& widgets, const Pick& pick) {
    widgets.heading("Pixel");
    const auto line = [&](const char* label, const std::string& text) {
        widgets.row(label);
        ImGui::TextUnformatted(text.c_str());
    };
    line("Where", std::to_string(pick.x) + ", " + std::to_string(pick.y));
    line("Normal", colour_text(pick.directions.normal));
    line("Mirror", colour_text(pick.directions.mirror));
    line("Shown", colour_text(pick.shown));
    line("Exact", colour_text(pick.exact));
    char text[48];
    std::snprintf(text, sizeof text, "%.2g  at n = %.4g", double(relative_error(pick)),
                  double(pick.exponent));
    line("Error", text);
}

} // namespace

void Panel::draw_status(const Status& status) {
    if (status.pick) draw_pick(widgets_, *status.pick);
    widgets_.heading("Now");
    if (!status.loading.empty()) {
        ImGui::TextWrapped("reading %s, %.1f s", status.loading.c_str(), status.loading_seconds);
    } else if (status.maps_done < 1.0) {
        ImGui::ProgressBar(float(status.maps_done), ImVec2(-1.0f, 0.0f), "prefiltering");
    } else if (status.reference_done && *status.reference_done < 1.0) {
        char text[48];
        std::snprintf(text, sizeof text, "reference %.1f %%", 100.0 * *status.reference_done);
        ImGui::ProgressBar(float(*status.reference_done), ImVec2(-1.0f, 0.0f), text);
    }
    if (!status.message.empty()) {
        if (status.is_bad) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.62f, 0.5f, 1.0f));
        ImGui::TextWrapped("%s", status.message.c_str());
        if (status.is_bad) ImGui::PopStyleColor();
    }
    ImGui::TextDisabled("%.0f frames/s, CPU %.1f ms a frame", status.frames_per_second,
                        status.cpu_ms);
    ImGui::TextDisabled("passes in this frame: %zu, of the prefilter: %zu", status.passes,
                        status.prefilters);
    ImGui::TextDisabled("maps %.1f MB, last work:", double(status.bytes) / (1024.0 * 1024.0));
    for (const PassTime& time : times_of(status.work))
        ImGui::TextDisabled("  %2d  %-12s %6.2f ms", time.count, time.name.c_str(),
                            time.milliseconds);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float bottom = ImGui::GetWindowHeight() - ImGui::GetStyle().WindowPadding.y - line;
    if (ImGui::GetCursorPosY() < bottom) ImGui::SetCursorPosY(bottom);
    ImGui::TextDisabled("F1 help, Tab hides this");
}

} // namespace lobelia::cli
