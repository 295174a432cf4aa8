#include "vk/functions.h"

#include <lobelia/version.h>

#include "vk/guard.h"

namespace lobelia {

std::uint32_t library_version() noexcept {
    return HEADER_VERSION;
}

} // namespace lobelia

namespace lobelia::vk {

Context load(const Device& device) {
    if (device.header_version / 1000 != library_version() / 1000)
        refuse("the headers are those of another version than the library");
    if (!device.handle || !device.get_device_proc_addr)
        refuse("Device needs a handle and get_device_proc_addr");
    Context context{device, {}};
#define X(name)                                                                                    \
    context.call.name =                                                                            \
        reinterpret_cast<PFN_##name>(device.get_device_proc_addr(device.handle, #name));           \
    if (!context.call.name)                                                                        \
        throw Error{VK_ERROR_INITIALIZATION_FAILED, "load device function " #name};
    LOBELIA_DEVICE_FUNCTIONS(X)
#undef X
    if (!device.debug_utils) return context;
#define X(name)                                                                                    \
    context.call.name =                                                                            \
        reinterpret_cast<PFN_##name>(device.get_device_proc_addr(device.handle, #name));           \
    if (!context.call.name)                                                                        \
        warn(context, "no debug names: debug_utils is set, but the device has no " #name);
    LOBELIA_DEBUG_FUNCTIONS(X)
#undef X
    return context;
}

} // namespace lobelia::vk
