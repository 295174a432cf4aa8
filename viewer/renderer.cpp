#include "renderer.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

// What is behind the panel until there is a picture.
void clear(VkCommandBuffer commands, VkExtent2D extent) {
    const VkClearAttachment grey{.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                                 .clearValue = {.color = {.float32 = {0.05f, 0.05f, 0.05f, 1.0f}}}};
    const VkClearRect everywhere{.rect = {{0, 0}, extent}, .layerCount = 1};
    vkCmdClearAttachments(commands, 1, &grey, 1, &everywhere);
}

} // namespace

Outcome<std::unique_ptr<Renderer>> Renderer::create(const GpuChoice& choice, const Window& window) {
    std::unique_ptr<Renderer> renderer(new Renderer);
    auto gpu = start_gpu(choice, window.presentation());
    if (!gpu) return gpu.error();
    renderer->gpu_ = std::make_unique<host::Gpu>(std::move(*gpu));
    auto swapchain = Swapchain::create(*renderer->gpu_);
    if (!swapchain) return swapchain.error();
    renderer->swapchain_ = std::move(*swapchain);
    auto stage = Stage::create(*renderer->gpu_);
    if (!stage) return stage.error();
    renderer->stage_ = std::move(*stage);
    auto display =
        Display::create(renderer->gpu_->device().handle, renderer->swapchain_->render_pass());
    if (!display) return display.error();
    renderer->display_ = std::move(*display);
    if (const auto loaded = renderer->reload_fonts(); !loaded) return loaded.error();
    return renderer;
}

Outcome<Done> Renderer::reload_fonts() {
    gui_.reset();
    auto gui = GuiRenderer::create(*gpu_, swapchain_->render_pass(), swapchain_->image_count());
    if (!gui) return gui.error();
    gui_ = std::move(*gui);
    return Done{};
}

Outcome<bool> Renderer::fit(VkExtent2D window) {
    if (window.width == 0 || window.height == 0) return false;
    const VkExtent2D now = swapchain_->extent();
    if (swapchain_->is_stale() || now.width != window.width || now.height != window.height)
        if (const auto resized = swapchain_->resize(window); !resized) return resized.error();
    return swapchain_->image_count() > 0;
}

Outcome<Done> Renderer::show(const ViewState& state) {
    const VkExtent2D extent = swapchain_->extent();
    if (stage_->has_pictures()) {
        DisplayVariant variant = stage_->display_variant(state);
        variant.encode = !swapchain_->encodes_srgb();
        const auto bound = display_->bind(stage_->display_sources(state), variant);
        if (!bound) return bound;
    }
    return swapchain_->show([&](VkCommandBuffer commands) {
        if (stage_->has_pictures()) {
            display_->record(commands, stage_->display_params(state, extent), extent);
        } else {
            clear(commands, extent);
        }
        gui_->record(commands);
    });
}

bool Renderer::is_lost() const {
    return vkDeviceWaitIdle(gpu_->device().handle) == VK_ERROR_DEVICE_LOST;
}

} // namespace lobelia::cli
