#include "host/colour_target.h"

#include "host/gpu_instance.h"

#define LOBELIA_RENDER_PASS_FUNCTIONS(X)                                                           \
    X(vkCmdBeginRenderPass)                                                                        \
    X(vkCmdEndRenderPass)                                                                          \
    X(vkCreateFramebuffer)                                                                         \
    X(vkCreateRenderPass)                                                                          \
    X(vkDestroyFramebuffer)                                                                        \
    X(vkDestroyRenderPass)

namespace lobelia::host {

namespace {

struct RenderPassFunctions {
#define X(name) PFN_##name name = nullptr;
    LOBELIA_RENDER_PASS_FUNCTIONS(X)
#undef X
};

struct RenderPassContext {
    Device device;
    RenderPassFunctions call;
};

template <class Handle, auto destroy>
using Object = vk::Unique<RenderPassContext, Handle, destroy>;

Outcome<RenderPassFunctions> load_functions(const Device& device) {
    RenderPassFunctions call;
#define X(name)                                                                                    \
    call.name = reinterpret_cast<PFN_##name>(device.get_device_proc_addr(device.handle, #name));   \
    if (!call.name) return Failure{"the Vulkan driver has no " #name ", update it"};
    LOBELIA_RENDER_PASS_FUNCTIONS(X)
#undef X
    return call;
}

Outcome<VkRenderPass> make_render_pass(const RenderPassContext& context, VkFormat format) {
    const VkAttachmentDescription attachment{.format = format,
                                             .samples = VK_SAMPLE_COUNT_1_BIT,
                                             .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                             .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                             .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                             .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                             .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                                             .finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                       .colorAttachmentCount = 1,
                                       .pColorAttachments = &reference};
    const VkSubpassDependency dependencies[] = {
        {.srcSubpass = VK_SUBPASS_EXTERNAL,
         .dstSubpass = 0,
         .srcStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT,
         .dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .srcAccessMask = VK_ACCESS_TRANSFER_READ_BIT,
         .dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT},
        {.srcSubpass = 0,
         .dstSubpass = VK_SUBPASS_EXTERNAL,
         .srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT,
         .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
         .dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT}};
    const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                      .attachmentCount = 1,
                                      .pAttachments = &attachment,
                                      .subpassCount = 1,
                                      .pSubpasses = &subpass,
                                      .dependencyCount = 2,
                                      .pDependencies = dependencies};
    VkRenderPass handle = VK_NULL_HANDLE;
    const VkResult code =
        context.call.vkCreateRenderPass(context.device.handle, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return failed("create a render pass", code);
    return handle;
}

Outcome<VkFramebuffer> make_framebuffer(const RenderPassContext& context, VkRenderPass pass,
                                        const GpuImage& image) {
    const VkImageView view = image.view();
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = pass,
                                       .attachmentCount = 1,
                                       .pAttachments = &view,
                                       .width = image.description().width,
                                       .height = image.description().height,
                                       .layers = 1};
    VkFramebuffer handle = VK_NULL_HANDLE;
    const VkResult code =
        context.call.vkCreateFramebuffer(context.device.handle, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return failed("create a framebuffer", code);
    return handle;
}

} // namespace

struct ColourTarget::State {
    RenderPassContext context;
    GpuImage image;
    Object<VkRenderPass, &RenderPassFunctions::vkDestroyRenderPass> render_pass;
    Object<VkFramebuffer, &RenderPassFunctions::vkDestroyFramebuffer> framebuffer;
};

ColourTarget::ColourTarget(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
ColourTarget::ColourTarget(ColourTarget&&) noexcept = default;
ColourTarget& ColourTarget::operator=(ColourTarget&&) noexcept = default;
ColourTarget::~ColourTarget() = default;

Outcome<ColourTarget> ColourTarget::create(Gpu& gpu, std::uint32_t width, std::uint32_t height) {
    const auto call = load_functions(gpu.device());
    if (!call) return call.error();
    auto image = gpu.create_image(
        {.width = width,
         .height = height,
         .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    if (!image) return image.error();
    std::unique_ptr<State> state(new State{{gpu.device(), *call}, std::move(*image), {}, {}});

    const auto pass = make_render_pass(state->context, state->image.description().format);
    if (!pass) return pass.error();
    state->render_pass = {state->context, *pass};
    const auto framebuffer = make_framebuffer(state->context, *pass, state->image);
    if (!framebuffer) return framebuffer.error();
    state->framebuffer = {state->context, *framebuffer};
    return ColourTarget(std::move(state));
}

VkRenderPass ColourTarget::render_pass() const {
    return state_->render_pass.get();
}
const GpuImage& ColourTarget::image() const {
    return state_->image;
}

void ColourTarget::record(VkCommandBuffer commands,
                          const std::function<void(VkCommandBuffer)>& draw) const {
    const GpuImageDescription& shape = state_->image.description();
    const VkRenderPassBeginInfo begin{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                      .renderPass = state_->render_pass.get(),
                                      .framebuffer = state_->framebuffer.get(),
                                      .renderArea = {{0, 0}, {shape.width, shape.height}}};
    state_->context.call.vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    draw(commands);
    state_->context.call.vkCmdEndRenderPass(commands);
}

} // namespace lobelia::host
