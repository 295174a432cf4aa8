#pragma once

#include "vk/functions.h"

namespace lobelia::vk {

/// Names an object for debuggers, where the caller's device has names.
template <class Handle>
void set_name(const Context& context, VkObjectType type, Handle handle, const char* name) {
    if (!context.call.vkSetDebugUtilsObjectNameEXT) return;
    const VkDebugUtilsObjectNameInfoEXT info{
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
        .objectType = type,
        .objectHandle = (std::uint64_t)handle, // a pointer or a number
        .pObjectName = name};
    context.call.vkSetDebugUtilsObjectNameEXT(context.device.handle, &info); // names may be lost
}

/// Labels what is recorded while it lives, likewise.
class Label {
public:
    Label(const Context& context, VkCommandBuffer commands, const char* name) noexcept
        : context_(context), commands_(commands) {
        const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                         .pLabelName = name};
        if (begins()) context_.call.vkCmdBeginDebugUtilsLabelEXT(commands_, &label);
    }
    ~Label() {
        if (begins()) context_.call.vkCmdEndDebugUtilsLabelEXT(commands_);
    }
    Label(const Label&) = delete;
    Label& operator=(const Label&) = delete;

private:
    const Context& context_;
    VkCommandBuffer commands_;
    bool begins() const noexcept {
        return context_.call.vkCmdBeginDebugUtilsLabelEXT &&
               context_.call.vkCmdEndDebugUtilsLabelEXT;
    }
};

} // namespace lobelia::vk
