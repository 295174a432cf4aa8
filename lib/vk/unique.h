#pragma once

#include <utility>

#include <vulkan/vulkan_core.h>

namespace lobelia::vk {

/// Owns one Vulkan object made from `context` and destroys it with the device function `destroy`.
template <class Context, class Handle, auto destroy>
class Unique {
public:
    Unique() = default;
    Unique(const Context& context, Handle handle) : context_(&context), handle_(handle) {}
    Unique(Unique&& other) noexcept
        : context_(other.context_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
    Unique& operator=(Unique other) noexcept {
        std::swap(context_, other.context_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Unique() {
        if (handle_)
            (context_->call.*destroy)(context_->device.handle, handle_, context_->device.allocator);
    }

    Handle get() const { return handle_; }

private:
    const Context* context_ = nullptr;
    Handle handle_ = VK_NULL_HANDLE;
};

} // namespace lobelia::vk
