#pragma once

#include <utility>
#include <variant>

#include <vulkan/vulkan_core.h>

namespace lobelia {

/// Why a call of the core library failed. `code` is what Vulkan answered, or
/// VK_ERROR_VALIDATION_FAILED_EXT where the caller broke a documented rule; `step` is a sentence
/// fragment that names what was being done ("create image view") or which rule was broken. It
/// points to static text.
struct Error {
    VkResult code = VK_ERROR_UNKNOWN;
    const char* step = "";
};

/// What a call without a value to return gives when it succeeds.
struct Done {};

/// A value, or the reason why there is none. Test it before use; reading the wrong one is
/// undefined.
template <class T, class E = Error>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(E error) : content_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const noexcept { return content_.index() == 0; }
    T& operator*() & noexcept { return *std::get_if<0>(&content_); }
    const T& operator*() const& noexcept { return *std::get_if<0>(&content_); }
    T&& operator*() && noexcept { return std::move(*std::get_if<0>(&content_)); }
    T* operator->() noexcept { return std::get_if<0>(&content_); }
    const T* operator->() const noexcept { return std::get_if<0>(&content_); }
    const E& error() const noexcept { return *std::get_if<1>(&content_); }

private:
    std::variant<T, E> content_;
};

} // namespace lobelia
