// An engine of Vulkan 1.1 with a VkRenderPass and no optional feature: the same picture.
#include "lighting.h"

namespace {

VkRenderPass make_render_pass(const Engine& engine) {
    const VkAttachmentDescription colour{.format = Canvas::FORMAT,
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
    const VkSubpassDependency to_the_copy{.srcSubpass = 0,
                                          .dstSubpass = VK_SUBPASS_EXTERNAL,
                                          .srcStageMask =
                                              VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                                          .dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT,
                                          .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                          .dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT};
    const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                      .attachmentCount = 1,
                                      .pAttachments = &colour,
                                      .subpassCount = 1,
                                      .pSubpasses = &subpass,
                                      .dependencyCount = 1,
                                      .pDependencies = &to_the_copy};
    VkRenderPass pass = VK_NULL_HANDLE;
    check(vkCreateRenderPass(engine.device, &info, nullptr, &pass), "create a render pass");
    return pass;
}

VkFramebuffer make_framebuffer(const Engine& engine, VkRenderPass pass, const Canvas& canvas) {
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = pass,
                                       .attachmentCount = 1,
                                       .pAttachments = &canvas.image.view,
                                       .width = canvas.width,
                                       .height = canvas.height,
                                       .layers = 1};
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    check(vkCreateFramebuffer(engine.device, &info, nullptr, &framebuffer), "make a framebuffer");
    return framebuffer;
}

void draw(const Engine& engine, const char* path) {
    const lobelia::Device device{engine.device, vkGetDeviceProcAddr};
    const lobelia::SphereView view = default_view();
    const Lighting lighting = Lighting::create(engine, device, 64, 64);
    const Canvas canvas = Canvas::create(engine, view.width, view.height);
    const VkRenderPass pass = make_render_pass(engine);
    const VkFramebuffer framebuffer = make_framebuffer(engine, pass, canvas);
    const auto sphere = expect(lobelia::Sphere::create(device, {.render_pass = pass},
                                                       {.method = lobelia::SphereMethod::two_tap}));
    const auto job = expect(sphere.bind(lighting.sphere_sources()));

    const VkCommandBuffer commands = engine.begin();
    lighting.record(commands);
    const VkRenderPassBeginInfo begin{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                      .renderPass = pass,
                                      .framebuffer = framebuffer,
                                      .renderArea = {{0, 0}, {canvas.width, canvas.height}}};
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    job.record(commands, view);
    vkCmdEndRenderPass(commands);
    canvas.read_back(commands);
    engine.submit_and_wait(commands);
    canvas.write(path);

    vkDestroyFramebuffer(engine.device, framebuffer, nullptr);
    vkDestroyRenderPass(engine.device, pass, nullptr);
    canvas.destroy(engine);
    lighting.destroy(engine);
}

} // namespace

int main(int, char** arguments) {
    Engine engine = Engine::create(VK_API_VERSION_1_1);
    draw(engine, arguments[1]);
    engine.destroy();
}
