#include "vk/functions.h"

namespace lobelia::vk {

Result<Context> load(const Device& device) {
    if (!device.handle || !device.get_device_proc_addr)
        return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                     "Device needs a handle and get_device_proc_addr"};
    Context context{device, {}};
#define X(name)                                                                                    \
    context.call.name =                                                                            \
        reinterpret_cast<PFN_##name>(device.get_device_proc_addr(device.handle, #name));           \
    if (!context.call.name)                                                                        \
        return Error{VK_ERROR_INITIALIZATION_FAILED, "load device function " #name};
    LOBELIA_DEVICE_FUNCTIONS(X)
#undef X
    return context;
}

} // namespace lobelia::vk
