#include "gui.h"

#include <cmath>
#include <filesystem>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr float TEXT_SIZE = 15.0f; // pixels at scale 1
constexpr const char* FONTS[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                 "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                 "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};

// Calm: greys with one accent, so that the picture's colours are the only ones.
void set_colours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    const ImVec4 accent(0.45f, 0.62f, 0.80f, 1.0f);
    const auto grey = [](float value, float alpha) { return ImVec4(value, value, value, alpha); };
    const auto dimmed = [&](float factor) {
        return ImVec4(accent.x * factor, accent.y * factor, accent.z * factor, 1.0f);
    };
    ImVec4* const colours = style.Colors;
    colours[ImGuiCol_Text] = grey(0.92f, 1.0f);
    colours[ImGuiCol_TextDisabled] = grey(0.62f, 1.0f);
    colours[ImGuiCol_WindowBg] = grey(0.09f, 0.93f);
    colours[ImGuiCol_PopupBg] = grey(0.11f, 0.98f);
    colours[ImGuiCol_Border] = grey(0.24f, 1.0f);
    for (const int item : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header})
        colours[item] = grey(0.19f, 1.0f);
    for (const int item : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
        colours[item] = grey(0.26f, 1.0f);
    for (const int item : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
        colours[item] = dimmed(0.7f);
    for (const int item : {ImGuiCol_SliderGrab, ImGuiCol_CheckMark, ImGuiCol_NavHighlight,
                           ImGuiCol_SliderGrabActive})
        colours[item] = accent;
    colours[ImGuiCol_PlotHistogram] = dimmed(0.55f);
    colours[ImGuiCol_SliderGrab] = dimmed(0.85f);
}

} // namespace

Gui::Gui(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // nothing is left behind in the folder
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForVulkan(window, true);
}

Gui::~Gui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::set_scale(float scale) {
    scale_ = scale;
    ImGuiStyle style;
    set_colours(style);
    style.WindowRounding = 0.0f;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 3.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowPadding = ImVec2(14, 6);
    style.FramePadding = ImVec2(6, 3);
    style.ItemSpacing = ImVec2(7, 4);
    style.GrabMinSize = 7.0f;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;

    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    for (const char* const path : FONTS) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        if (fonts.AddFontFromFileTTF(path, std::round(TEXT_SIZE * scale))) return;
    }
    ImFontConfig config;
    config.SizePixels = std::round(13.0f * scale); // what that font is drawn for
    fonts.AddFontDefault(&config);
}

bool Gui::begin_frame(std::span<const KeyPress> pressed) {
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : held_) io.KeysDown[key] = false;
    held_.clear();
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    bool is_tab = false;
    for (const auto& [key, modifiers] : pressed) {
        if (modifiers & GLFW_MOD_CONTROL) io.KeyCtrl = true;
        if (modifiers & GLFW_MOD_SHIFT) io.KeyShift = true;
        if (key == GLFW_KEY_TAB && !io.WantTextInput) is_tab = true;
        if (io.KeysDown[key]) continue;
        io.KeysDown[key] = true;
        held_.push_back(key);
    }
    if (!io.WantTextInput) io.KeysDown[GLFW_KEY_TAB] = false;
    ImGui::NewFrame();
    return is_tab;
}

void Gui::end_frame() const {
    ImGui::Render();
}

Outcome<std::unique_ptr<GuiRenderer>> GuiRenderer::create(host::Gpu& gpu, VkRenderPass pass,
                                                          std::uint32_t image_count) {
    std::unique_ptr<GuiRenderer> renderer(new GuiRenderer);
    const VkDevice device = gpu.device().handle;
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
    const VkDescriptorPoolCreateInfo pool_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
        .flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
        .maxSets = 1,
        .poolSizeCount = 1,
        .pPoolSizes = &size};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    const VkResult code = vkCreateDescriptorPool(device, &pool_info, nullptr, &pool);
    if (code != VK_SUCCESS) return vulkan_failure("create a descriptor pool", code);
    renderer->pool_ = {device, pool};
    renderer->device_ = device;
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = gpu.instance();
    info.PhysicalDevice = gpu.physical_device();
    info.Device = device;
    info.QueueFamily = gpu.queue_family();
    info.Queue = gpu.queue();
    info.DescriptorPool = pool;
    info.MinImageCount = 2;
    info.ImageCount = std::max(image_count, 2u);
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    if (!ImGui_ImplVulkan_Init(&info, pass)) return host::Failure{"the panel cannot be drawn"};
    renderer->started_ = true;
    const auto uploaded =
        gpu.submit([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    if (!uploaded) return uploaded.error();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
    return renderer;
}

GuiRenderer::~GuiRenderer() {
    if (!started_) return;
    vkDeviceWaitIdle(device_);
    ImGui_ImplVulkan_Shutdown();
}

void GuiRenderer::record(VkCommandBuffer commands) const {
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

} // namespace lobelia::cli
