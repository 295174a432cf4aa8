// An engine with a mistake, which validation must report: a test that listens can hear. `mistake
// layout` makes a transition to no layout, `mistake hazard` writes twice without a barrier.
#include <string_view>

#include "engine.h"

int main(int argc, char** argv) {
    const std::string_view kind = argc > 1 ? argv[1] : "";
    Engine engine = Engine::create(VK_API_VERSION_1_1);
    const Image image = engine.make_image({});
    constexpr VkDeviceSize SIZE = 16;
    const Buffer buffer = engine.make_buffer(SIZE, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const VkCommandBuffer commands = engine.begin();
    if (kind == "layout")
        transition(commands, image.handle, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_UNDEFINED);
    else if (kind == "hazard")
        for (int i = 0; i < 2; ++i) vkCmdFillBuffer(commands, buffer.handle, 0, SIZE, 0);
    else
        fail("make this mistake, name layout or hazard");
    engine.submit_and_wait(commands);
    engine.destroy(buffer);
    engine.destroy(image);
    engine.destroy();
}
