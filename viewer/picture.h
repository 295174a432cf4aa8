#pragma once

#include <optional>

#include "colour_pass.h"

namespace lobelia::cli {

/// A picture in linear radiance that is drawn offscreen and then shown, R32G32B32A32_SFLOAT.
class Picture {
public:
    static constexpr VkFormat FORMAT = VK_FORMAT_R32G32B32A32_SFLOAT;
    static constexpr VkImageLayout LAYOUT = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

    /// `pass` comes from make_colour_pass(FORMAT, LAYOUT).
    static host::Outcome<Picture> create(host::Gpu& gpu, VkRenderPass pass, VkExtent2D extent);

    VkExtent2D extent() const { return extent_; }
    VkImageView view() const { return image_.view(); }

    /// Records `pass`, which is compatible with that of create(), around `draw`. Leaves the picture
    /// in LAYOUT.
    void record(VkCommandBuffer commands, VkRenderPass pass,
                const std::function<void(VkCommandBuffer)>& draw) const {
        record_colour_pass(commands, pass, framebuffer_.get(), extent_, draw);
    }

    host::Outcome<host::Image> download(host::Gpu& gpu) const {
        return gpu.download(image_, LAYOUT);
    }

private:
    Picture(host::GpuImage image, OwnedFramebuffer framebuffer, VkExtent2D extent)
        : image_(std::move(image)), framebuffer_(std::move(framebuffer)), extent_(extent) {}

    host::GpuImage image_;
    OwnedFramebuffer framebuffer_;
    VkExtent2D extent_;
};

} // namespace lobelia::cli
