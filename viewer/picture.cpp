#include "picture.h"

namespace lobelia::cli {

using host::Outcome;

Outcome<Picture> Picture::create(host::Gpu& gpu, VkRenderPass pass, VkExtent2D extent) {
    auto image =
        gpu.create_image({.format = FORMAT,
                          .width = extent.width,
                          .height = extent.height,
                          .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    if (!image) return image.error();
    auto framebuffer = make_framebuffer(gpu.device().handle, pass, image->view(), extent);
    if (!framebuffer) return framebuffer.error();
    return Picture(std::move(*image), std::move(*framebuffer), extent);
}

} // namespace lobelia::cli
