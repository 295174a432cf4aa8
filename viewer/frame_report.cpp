#include "frame_report.h"

#include "command_line.h"
#include "quality.h"
#include "sphere_options.h"

namespace lobelia::cli {

std::string as_json_line(const FrameReport& report, const ViewState& state, const Status& status,
                         const Places& places) {
    using nlohmann::json;
    json passes = json::array();
    for (const host::PassReport& pass : report.work) passes.push_back(pass.name);
    const Material& material = state.material();
    const ImGuiIO& io = ImGui::GetIO();
    const json line = {
        {"frame", report.frame},
        {"seconds", report.seconds},
        {"cpu_ms", status.cpu_ms},
        {"width", report.size.width},
        {"height", report.size.height},
        {"device", status.device},
        {"passes", passes},
        {"prefilter_passes", prefilter_passes(report.work)},
        {"busy", report.busy},
        {"environment", state.environment},
        {"environments_shown", report.environments},
        {"loading", status.loading},
        {"message", status.message},
        {"kd", material.diffuse},
        {"ks", material.specular},
        {"n", material.exponent},
        {"method", method_name(state.settings.method)},
        {"right_method", state.split ? json(method_name(state.other)) : json()},
        {"divider", state.divider},
        {"quality", quality_name(state.settings.quality)},
        {"errors", state.errors},
        {"eye", state.settings.view.camera.eye},
        {"rotation", state.rotation},
        {"exposure", state.exposure},
        {"panel", state.panel},
        {"mouse", {io.MousePos.x, io.MousePos.y}},
        {"pressed", io.MouseDown[ImGuiMouseButton_Left]},
        {"typing", io.WantTextInput},
        {"help", state.help},
        {"reference", status.reference_done ? json(*status.reference_done) : json()},
        {"pick", status.pick ? json{{"x", status.pick->x},
                                    {"y", status.pick->y},
                                    {"normal", status.pick->directions.normal},
                                    {"mirror", status.pick->directions.mirror},
                                    {"n", status.pick->exponent},
                                    {"shown", status.pick->shown},
                                    {"exact", status.pick->exact},
                                    {"error", relative_error(*status.pick)}}
                             : json()},
        {"command", command_line(state, report.size)},
        {"controls", places},
    };
    return line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

} // namespace lobelia::cli
