// An engine with a mistake, which validation must report: a test that listens can hear.
#include "engine.h"

int main() {
    Engine engine = Engine::create(VK_API_VERSION_1_1);
    const Image image = engine.make_image({});
    const VkCommandBuffer commands = engine.begin();
    transition(commands, image.handle, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_UNDEFINED);
    engine.submit_and_wait(commands);
    engine.destroy(image);
    engine.destroy();
}
