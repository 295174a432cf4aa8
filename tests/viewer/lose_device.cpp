// Preloaded, it loses the device at the first submission after a file appears, and with it every
// later call on that device that would tell; devices made afterwards work.

#include <cstdint>
#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>

#include <vulkan/vulkan.h>

namespace {

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool is_lost = false;
bool was_lost = false;

bool loses_now() {
    const char* const file = std::getenv("LOBELIA_LOSE_DEVICE_FILE");
    if (!was_lost && file && access(file, F_OK) == 0) is_lost = was_lost = true;
    return is_lost;
}

} // namespace

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit(VkQueue queue, std::uint32_t count,
                                             const VkSubmitInfo* infos, VkFence fence) {
    if (loses_now()) return VK_ERROR_DEVICE_LOST;
    return real<PFN_vkQueueSubmit>("vkQueueSubmit")(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL vkDeviceWaitIdle(VkDevice device) {
    const VkResult code = real<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(device);
    return is_lost ? VK_ERROR_DEVICE_LOST : code;
}

VKAPI_ATTR void VKAPI_CALL vkDestroySwapchainKHR(VkDevice device, VkSwapchainKHR swapchain,
                                                 const VkAllocationCallbacks* allocator) {
    is_lost = false; // the program lets go of it
    real<PFN_vkDestroySwapchainKHR>("vkDestroySwapchainKHR")(device, swapchain, allocator);
}
}
