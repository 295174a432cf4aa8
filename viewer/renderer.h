#pragma once

#include <memory>

#include "display.h"
#include "gpu_choice.h"
#include "gui.h"
#include "stage.h"
#include "swapchain.h"
#include "window.h"

namespace lobelia::cli {

/// Everything of the viewer that lies on the device: to be made anew where the device is lost.
class Renderer {
public:
    /// `window` and the Gui that is current outlive it.
    static host::Outcome<std::unique_ptr<Renderer>> create(const GpuChoice& choice,
                                                           const Window& window);

    host::Gpu& gpu() { return *gpu_; }
    Stage& stage() { return *stage_; }

    /// Fits the window's images to its size; false where there is nothing to draw on now.
    host::Outcome<bool> fit(VkExtent2D window);
    VkExtent2D extent() const { return swapchain_->extent(); }
    /// Waits until the last frame is drawn: what it shows may change then.
    host::Outcome<Done> finish() { return swapchain_->finish(); }
    /// Shows the stage's pictures with the panel over them.
    host::Outcome<Done> show(const ViewState& state);
    /// After Gui::set_scale().
    host::Outcome<Done> reload_fonts();

    /// Whether the device answers nothing any more.
    bool is_lost() const;

private:
    Renderer() = default;
    std::unique_ptr<host::Gpu> gpu_;
    std::optional<Swapchain> swapchain_;
    std::optional<Stage> stage_;
    std::optional<Display> display_;
    std::unique_ptr<GuiRenderer> gui_;
};

} // namespace lobelia::cli
