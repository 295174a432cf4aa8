#pragma once

#include <functional>
#include <vector>

#include "colour_pass.h"

namespace lobelia::cli {

/// The window's images, and the commands that fill and show them: one frame at a time.
class Swapchain {
public:
    /// For the surface of `gpu`, which outlives this. Has no images until resize().
    static host::Outcome<Swapchain> create(host::Gpu& gpu);
    Swapchain(Swapchain&&) noexcept = default;
    Swapchain& operator=(Swapchain&&) noexcept = default;
    ~Swapchain();

    VkRenderPass render_pass() const { return pass_.get(); }
    bool encodes_srgb() const; // when it is written to
    std::uint32_t image_count() const { return std::uint32_t(images_.size()); }
    VkExtent2D extent() const { return extent_; }

    /// Makes images as large as the surface, or `wanted` where that does not say. None where the
    /// surface has no size now: then there is nothing to draw.
    host::Outcome<Done> resize(VkExtent2D wanted);
    bool is_stale() const { return images_.empty() || stale_; }

    /// Waits until the last frame is drawn.
    host::Outcome<Done> finish();

    /// Draws into the next image by `draw`, within the render pass, and shows it. Without a picture
    /// when the surface has changed: is_stale() then.
    host::Outcome<Done> show(const std::function<void(VkCommandBuffer)>& draw);

private:
    struct Image {
        OwnedImageView view;
        OwnedFramebuffer framebuffer;
        OwnedSemaphore drawn;
    };
    explicit Swapchain(host::Gpu& gpu) : gpu_(&gpu) {}
    host::Outcome<Done> make_commands();
    host::Outcome<Done> make_images();
    host::Outcome<Done> submit(const Image& image,
                               const std::function<void(VkCommandBuffer)>& draw);

    host::Gpu* gpu_;
    VkSurfaceFormatKHR format_{};
    OwnedRenderPass pass_;
    OwnedCommandPool pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    OwnedFence done_;
    bool busy_ = false; // the fence will be signalled
    OwnedSwapchain swapchain_;
    OwnedSemaphore acquired_;
    std::vector<Image> images_;
    VkExtent2D extent_{};
    bool stale_ = false;
};

} // namespace lobelia::cli
