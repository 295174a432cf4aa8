#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <tuple>

#include <lobelia/device.h>

#include "vk/functions.h"

namespace lobelia::test {

/// A device whose functions do nothing but count: what the library itself does shows, without a
/// driver.
struct FakeDevice {
    using Count = std::atomic<std::uint64_t>; // several threads may use the device
    static inline Count made = 0;             // objects so far
    static inline Count destroyed = 0;
    static inline Count commands = 0;  // recorded
    static inline Count strangers = 0; // objects made or destroyed without the device's allocator

    /// One device for a whole program, since its functions are no object's.
    static Device lend() {
        return {
            .handle = handle<VkDevice>(), .get_device_proc_addr = &find, .allocator = &ALLOCATOR};
    }

    template <class Handle>
    static Handle handle() { // a new one
        static Count last = 0;
        return (Handle)++last; // a pointer or a number
    }

private:
    static constexpr VkAllocationCallbacks ALLOCATOR{}; // nobody calls it

    static void expect_allocator(const void* given) { strangers += given != &ALLOCATOR; }

    template <class... Arguments>
    using First = std::tuple_element_t<0, std::tuple<Arguments...>>;

    template <class Result, class... Arguments>
    static auto fake(Result (*)(Arguments...)) -> Result (*)(Arguments...) {
        return [](Arguments... arguments) -> Result {
            if constexpr (std::is_same_v<Result, VkResult>) { // the last argument is what is made
                const auto target = std::get<sizeof...(Arguments) - 1>(std::tuple(arguments...));
                expect_allocator(std::get<sizeof...(Arguments) - 2>(std::tuple(arguments...)));
                *target = handle<std::remove_pointer_t<decltype(target)>>();
                ++made;
                return VK_SUCCESS;
            } else { // a command, or the end of an object
                if constexpr (std::is_same_v<First<Arguments...>, VkCommandBuffer>) {
                    ((void)arguments, ...);
                    ++commands;
                } else {
                    expect_allocator(std::get<sizeof...(Arguments) - 1>(std::tuple(arguments...)));
                    ++destroyed;
                }
            }
        };
    }

    static VKAPI_ATTR VkResult VKAPI_CALL allocate_sets(VkDevice,
                                                        const VkDescriptorSetAllocateInfo* info,
                                                        VkDescriptorSet* sets) {
        for (std::uint32_t i = 0; i < info->descriptorSetCount; ++i)
            sets[i] = handle<VkDescriptorSet>();
        return VK_SUCCESS; // they go with their pool
    }

    static VKAPI_ATTR void VKAPI_CALL update_sets(VkDevice, std::uint32_t,
                                                  const VkWriteDescriptorSet*, std::uint32_t,
                                                  const VkCopyDescriptorSet*) {}

    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL find(VkDevice, const char* name) {
        const std::string wanted = name;
        if (wanted == "vkAllocateDescriptorSets")
            return reinterpret_cast<PFN_vkVoidFunction>(&allocate_sets);
        if (wanted == "vkUpdateDescriptorSets")
            return reinterpret_cast<PFN_vkVoidFunction>(&update_sets);
#define X(function)                                                                                \
    if (wanted == #function)                                                                       \
        return reinterpret_cast<PFN_vkVoidFunction>(fake(PFN_##function(nullptr)));
        LOBELIA_DEVICE_FUNCTIONS(X)
#undef X
        return nullptr;
    }
};

} // namespace lobelia::test
