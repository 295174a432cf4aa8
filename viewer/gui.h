#pragma once

#include <memory>

#include <lobelia/host/gpu.h>

#include "owned.h"

struct GLFWwindow;

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

    /// True where Tab was pressed, which is not ours to move on with while nothing is typed.
    bool begin_frame();
    void end_frame() const;

private:
    float scale_ = 0.0f;
    bool tab_was_down_ = false;
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
