#include "controls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <GLFW/glfw3.h>

#include "orbit.h"

namespace lobelia::cli {

namespace {

constexpr double RADIANS_A_WINDOW = std::numbers::pi; // of a drag over its height
constexpr double CLOSER_A_NOTCH = 0.9;                // of the wheel; touchpads send parts of one
constexpr double KEY_STEP = 0.1;                      // radians
constexpr float SMALLEST_ZOOM = 0.5f, LARGEST_ZOOM = 3.0f;

bool pressed(int key) {
    return ImGui::IsKeyPressed(key, false);
}
bool repeated(int key) {
    return ImGui::IsKeyPressed(key, true);
}

float wrapped(float degrees) {
    return std::remainder(degrees, 360.0f);
}

void move_camera(Camera& camera) {
    if (repeated(GLFW_KEY_LEFT)) orbit(camera, -KEY_STEP, 0.0);
    if (repeated(GLFW_KEY_RIGHT)) orbit(camera, KEY_STEP, 0.0);
    if (repeated(GLFW_KEY_UP)) orbit(camera, 0.0, KEY_STEP);
    if (repeated(GLFW_KEY_DOWN)) orbit(camera, 0.0, -KEY_STEP);
}

void zoom_text(ViewState& state) {
    float zoom = state.zoom;
    if (pressed(GLFW_KEY_EQUAL) || pressed(GLFW_KEY_KP_ADD)) zoom += 0.25f;
    if (pressed(GLFW_KEY_MINUS) || pressed(GLFW_KEY_KP_SUBTRACT)) zoom -= 0.25f;
    if (pressed(GLFW_KEY_0)) zoom = 1.0f;
    state.zoom = std::clamp(zoom, SMALLEST_ZOOM, LARGEST_ZOOM);
}

} // namespace

void Controls::apply(ViewState& state, Requests& requests) {
    drag(state, requests);
    keys(state, requests);
    const ImGuiIO& io = ImGui::GetIO();
    if (state.turning != 0.0f)
        state.rotation = wrapped(state.rotation + state.turning * io.DeltaTime);
    if (io.WantCaptureMouse) return;
    Camera& camera = state.settings.view.camera;
    if (io.KeyShift || io.MouseWheelH != 0.0f)
        state.rotation = wrapped(state.rotation + 5.0f * (io.MouseWheel + io.MouseWheelH));
    else if (io.MouseWheel != 0.0f)
        move_eye(camera, std::pow(CLOSER_A_NOTCH, double(io.MouseWheel)));
}

void Controls::drag(ViewState& state, Requests& requests) {
    const ImGuiIO& io = ImGui::GetIO();
    const float line = state.divider * io.DisplaySize.x;
    const bool on_picture = !io.WantCaptureMouse;
    const bool at_line =
        state.split && on_picture && std::abs(io.MousePos.x - line) < 0.6f * ImGui::GetFontSize();
    if (at_line || drag_ == Drag::divider) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (on_picture && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        requests.pick = {
            std::uint32_t(std::max(io.MousePos.x * io.DisplayFramebufferScale.x, 0.0f)),
            std::uint32_t(std::max(io.MousePos.y * io.DisplayFramebufferScale.y, 0.0f))};
    if (on_picture && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !at_line)
        requests.reset_camera = true;
    if (on_picture && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        drag_ = at_line ? Drag::divider : io.KeyShift ? Drag::light : Drag::orbit;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) drag_ = Drag::none;

    const double scale = RADIANS_A_WINDOW / std::max(double(io.DisplaySize.y), 1.0);
    const double across = scale * double(io.MouseDelta.x), down = scale * double(io.MouseDelta.y);
    if (drag_ == Drag::orbit && (across != 0.0 || down != 0.0))
        orbit(state.settings.view.camera, -across, down);
    if (drag_ == Drag::light)
        state.rotation = wrapped(state.rotation + float(across * 180.0 / std::numbers::pi));
    if (drag_ == Drag::divider && io.DisplaySize.x > 0.0f)
        state.divider = std::clamp(io.MousePos.x / io.DisplaySize.x, 0.02f, 0.98f);
}

void Controls::keys(ViewState& state, Requests& requests) const {
    if (pressed(GLFW_KEY_F1)) state.help = !state.help;
    if (pressed(GLFW_KEY_ESCAPE)) state.help = false;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    Camera& camera = state.settings.view.camera;
    if (repeated(GLFW_KEY_PAGE_UP)) move_eye(camera, CLOSER_A_NOTCH);
    if (repeated(GLFW_KEY_PAGE_DOWN)) move_eye(camera, 1.0 / CLOSER_A_NOTCH);
    if (pressed(GLFW_KEY_HOME)) requests.reset_camera = true;
    if (io.KeyCtrl) {
        requests.quit |= pressed(GLFW_KEY_Q);
        move_camera(camera);
        zoom_text(state);
        return;
    }
    if (pressed(GLFW_KEY_S)) state.split = !state.split;
    if (pressed(GLFW_KEY_F)) std::swap(state.settings.method, state.other);
    if (pressed(GLFW_KEY_E)) state.errors = !state.errors;
    if (pressed(GLFW_KEY_1)) state.lobes = Lobes::both;
    if (pressed(GLFW_KEY_2)) state.lobes = Lobes::diffuse;
    if (pressed(GLFW_KEY_3)) state.lobes = Lobes::specular;
    if (pressed(GLFW_KEY_B)) state.background = Background((int(state.background) + 1) % 3);
    if (pressed(GLFW_KEY_T)) state.turning = state.turning == 0.0f ? DEGREES_A_SECOND : 0.0f;
    requests.save_png |= pressed(GLFW_KEY_P);
    requests.save_exr |= pressed(GLFW_KEY_X);
    requests.copy_command |= pressed(GLFW_KEY_C);
}

} // namespace lobelia::cli
