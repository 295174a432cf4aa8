#include "swapchain.h"

#include <algorithm>

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr std::uint64_t WAIT_NANOSECONDS = 10'000'000'000; // a frame takes a fraction of it

Outcome<VkSurfaceFormatKHR> choose_format(const host::Gpu& gpu) {
    std::uint32_t count = 0;
    VkResult code =
        vkGetPhysicalDeviceSurfaceFormatsKHR(gpu.physical_device(), gpu.surface(), &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    if (code == VK_SUCCESS)
        code = vkGetPhysicalDeviceSurfaceFormatsKHR(gpu.physical_device(), gpu.surface(), &count,
                                                    formats.data());
    if (code != VK_SUCCESS) return vulkan_failure("list the window's formats", code);
    // The panel's colours are sRGB as they are, so formats that encode are second choice.
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM,
                                  VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB})
        for (const VkSurfaceFormatKHR& format : formats)
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return format;
    return host::Failure{"the window takes no 8-bit sRGB pictures, pick another device"};
}

Outcome<OwnedSemaphore> make_semaphore(VkDevice device) {
    const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore handle = VK_NULL_HANDLE;
    const VkResult code = vkCreateSemaphore(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return vulkan_failure("create a semaphore", code);
    return OwnedSemaphore(device, handle);
}

} // namespace

Swapchain::~Swapchain() {
    if (pool_.get()) vkDeviceWaitIdle(gpu_->device().handle);
}

bool Swapchain::encodes_srgb() const {
    return format_.format == VK_FORMAT_B8G8R8A8_SRGB || format_.format == VK_FORMAT_R8G8B8A8_SRGB;
}

Outcome<Swapchain> Swapchain::create(host::Gpu& gpu) {
    Swapchain swapchain(gpu);
    const auto format = choose_format(gpu);
    if (!format) return format.error();
    swapchain.format_ = *format;
    auto pass =
        make_colour_pass(gpu.device().handle, format->format, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    if (!pass) return pass.error();
    swapchain.pass_ = std::move(*pass);
    if (const auto made = swapchain.make_commands(); !made) return made.error();
    return swapchain;
}

Outcome<Done> Swapchain::make_commands() {
    const VkDevice device = gpu_->device().handle;
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .queueFamilyIndex = gpu_->queue_family()};
    VkCommandPool pool = VK_NULL_HANDLE;
    VkResult code = vkCreateCommandPool(device, &pool_info, nullptr, &pool);
    if (code != VK_SUCCESS) return vulkan_failure("create a command pool", code);
    pool_ = {device, pool};
    const VkCommandBufferAllocateInfo allocation{.sType =
                                                     VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                 .commandPool = pool,
                                                 .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                 .commandBufferCount = 1};
    code = vkAllocateCommandBuffers(device, &allocation, &commands_);
    if (code != VK_SUCCESS) return vulkan_failure("allocate a command buffer", code);
    const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence = VK_NULL_HANDLE;
    code = vkCreateFence(device, &fence_info, nullptr, &fence);
    if (code != VK_SUCCESS) return vulkan_failure("create a fence", code);
    done_ = {device, fence};
    return Done{};
}

Outcome<Done> Swapchain::resize(VkExtent2D wanted) {
    const VkDevice device = gpu_->device().handle;
    VkSurfaceCapabilitiesKHR surface{};
    VkResult code = vkGetPhysicalDeviceSurfaceCapabilitiesKHR(gpu_->physical_device(),
                                                              gpu_->surface(), &surface);
    if (code != VK_SUCCESS) return vulkan_failure("look at the window's surface", code);
    VkExtent2D extent = surface.currentExtent;
    if (extent.width == UINT32_MAX)
        extent = {
            std::clamp(wanted.width, surface.minImageExtent.width, surface.maxImageExtent.width),
            std::clamp(wanted.height, surface.minImageExtent.height,
                       surface.maxImageExtent.height)};
    // Presentation may still hold semaphores of the old images.
    code = vkDeviceWaitIdle(device);
    if (code != VK_SUCCESS) return vulkan_failure("wait for the device", code);
    busy_ = false;
    images_.clear();
    stale_ = false;
    if (extent.width == 0 || extent.height == 0) return Done{};

    const std::uint32_t most = surface.maxImageCount ? surface.maxImageCount : UINT32_MAX;
    const VkCompositeAlphaFlagBitsKHR alpha =
        surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
            ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    const VkSwapchainCreateInfoKHR info{.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
                                        .surface = gpu_->surface(),
                                        .minImageCount = std::min(surface.minImageCount + 1, most),
                                        .imageFormat = format_.format,
                                        .imageColorSpace = format_.colorSpace,
                                        .imageExtent = extent,
                                        .imageArrayLayers = 1,
                                        .imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                        .preTransform = surface.currentTransform,
                                        .compositeAlpha = alpha,
                                        .presentMode = VK_PRESENT_MODE_FIFO_KHR,
                                        .clipped = VK_TRUE,
                                        .oldSwapchain = swapchain_.get()};
    VkSwapchainKHR handle = VK_NULL_HANDLE;
    code = vkCreateSwapchainKHR(device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return vulkan_failure("create a swapchain", code);
    swapchain_ = OwnedSwapchain(device, handle);
    extent_ = extent;
    return make_images();
}

Outcome<Done> Swapchain::make_images() {
    const VkDevice device = gpu_->device().handle;
    std::uint32_t count = 0;
    VkResult code = vkGetSwapchainImagesKHR(device, swapchain_.get(), &count, nullptr);
    std::vector<VkImage> handles(count);
    if (code == VK_SUCCESS)
        code = vkGetSwapchainImagesKHR(device, swapchain_.get(), &count, handles.data());
    if (code != VK_SUCCESS) return vulkan_failure("list the window's images", code);
    auto acquired = make_semaphore(device);
    if (!acquired) return acquired.error();
    acquired_ = std::move(*acquired);
    for (const VkImage image : handles) {
        const VkImageViewCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
            .image = image,
            .viewType = VK_IMAGE_VIEW_TYPE_2D,
            .format = format_.format,
            .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
        VkImageView view = VK_NULL_HANDLE;
        code = vkCreateImageView(device, &info, nullptr, &view);
        if (code != VK_SUCCESS) return vulkan_failure("create an image view", code);
        OwnedImageView owned(device, view);
        auto framebuffer = make_framebuffer(device, pass_.get(), view, extent_);
        if (!framebuffer) return framebuffer.error();
        auto drawn = make_semaphore(device);
        if (!drawn) return drawn.error();
        images_.push_back({std::move(owned), std::move(*framebuffer), std::move(*drawn)});
    }
    return Done{};
}

Outcome<Done> Swapchain::finish() {
    if (!busy_) return Done{};
    const VkFence fence = done_.get();
    const VkResult code =
        vkWaitForFences(gpu_->device().handle, 1, &fence, VK_TRUE, WAIT_NANOSECONDS);
    if (code != VK_SUCCESS) return vulkan_failure("finish a frame", code);
    busy_ = false;
    return Done{};
}

Outcome<Done> Swapchain::submit(const Image& image,
                                const std::function<void(VkCommandBuffer)>& draw) {
    const VkDevice device = gpu_->device().handle;
    VkResult code = vkResetCommandPool(device, pool_.get(), 0);
    if (code != VK_SUCCESS) return vulkan_failure("reset the command pool", code);
    const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                         .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    code = vkBeginCommandBuffer(commands_, &begin);
    if (code != VK_SUCCESS) return vulkan_failure("begin a command buffer", code);
    record_colour_pass(commands_, pass_.get(), image.framebuffer.get(), extent_, draw);
    code = vkEndCommandBuffer(commands_);
    if (code != VK_SUCCESS) return vulkan_failure("end a command buffer", code);

    const VkFence fence = done_.get();
    code = vkResetFences(device, 1, &fence);
    if (code != VK_SUCCESS) return vulkan_failure("reset a fence", code);
    const VkSemaphore acquired = acquired_.get(), drawn = image.drawn.get();
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    const VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                            .waitSemaphoreCount = 1,
                            .pWaitSemaphores = &acquired,
                            .pWaitDstStageMask = &stage,
                            .commandBufferCount = 1,
                            .pCommandBuffers = &commands_,
                            .signalSemaphoreCount = 1,
                            .pSignalSemaphores = &drawn};
    code = vkQueueSubmit(gpu_->queue(), 1, &info, fence);
    if (code != VK_SUCCESS) return vulkan_failure("submit a frame", code);
    busy_ = true;
    return Done{};
}

Outcome<Done> Swapchain::show(const std::function<void(VkCommandBuffer)>& draw) {
    if (const auto finished = finish(); !finished) return finished;
    std::uint32_t index = 0;
    VkResult code = vkAcquireNextImageKHR(gpu_->device().handle, swapchain_.get(), WAIT_NANOSECONDS,
                                          acquired_.get(), VK_NULL_HANDLE, &index);
    if (code == VK_ERROR_OUT_OF_DATE_KHR) {
        stale_ = true;
        return Done{};
    }
    if (code != VK_SUCCESS && code != VK_SUBOPTIMAL_KHR)
        return vulkan_failure("get the window's next image", code);
    stale_ = code == VK_SUBOPTIMAL_KHR;
    if (const auto submitted = submit(images_[index], draw); !submitted) return submitted;

    const VkSwapchainKHR swapchain = swapchain_.get();
    const VkSemaphore drawn = images_[index].drawn.get();
    const VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                                .waitSemaphoreCount = 1,
                                .pWaitSemaphores = &drawn,
                                .swapchainCount = 1,
                                .pSwapchains = &swapchain,
                                .pImageIndices = &index};
    code = vkQueuePresentKHR(gpu_->queue(), &info);
    if (code == VK_ERROR_OUT_OF_DATE_KHR || code == VK_SUBOPTIMAL_KHR)
        stale_ = true;
    else if (code != VK_SUCCESS)
        return vulkan_failure("show a frame", code);
    return Done{};
}

} // namespace lobelia::cli
