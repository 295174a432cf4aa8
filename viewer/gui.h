#pragma once

#include <memory>
#include <span>
#include <vector>

#include <lobelia/host/gpu.h>

#include "owned.h"
#include "window.h"

namespace lobelia::cli {

/// Dear ImGui in a window: its context with fonts and colours. One at a time.
class Gui {
public:
    explicit Gui(GLFWwindow* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Text and spacing that many times as large as at 96 dots an inch; before GuiRenderer.
    void set_scale(float scale);
    float scale() const { return scale_; }

    /// `pressed` since the last frame: each counts as down in this one, however short it was. True
    /// where Tab was among them and nothing is typed; it is then not used to go from control to
    /// control.
    bool begin_frame(std::span<const KeyPress> pressed);
    void end_frame() const;

private:
    float scale_ = 0.0f;
    std::vector<int> held_; // keys that are up but count as down in this frame
};

/// What draws it, on one device.
class GuiRenderer {
public:
    static host::Outcome<std::unique_ptr<GuiRenderer>> create(host::Gpu& gpu, VkRenderPass pass,
                                                              std::uint32_t image_count);
    ~GuiRenderer();
    GuiRenderer(const GuiRenderer&) = delete;
    GuiRenderer& operator=(const GuiRenderer&) = delete;

    /// Within the render pass, after Gui::end_frame().
    void record(VkCommandBuffer commands) const;

private:
    GuiRenderer() = default;
    OwnedDescriptorPool pool_;
    VkDevice device_ = VK_NULL_HANDLE;
    bool started_ = false;
};

} // namespace lobelia::cli
