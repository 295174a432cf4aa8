#include "vulkan_shim.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace lobelia::test {

namespace {

constexpr std::string_view NAMES[] = {
#define X(name, ...) #name,
    LOBELIA_SHIM_FUNCTIONS(X)
#undef X
};
constexpr std::string_view name_in_type(Call call) {
    return NAMES[std::size_t(call)];
}

// What the loader does not export is found by its name.
VkResult vkCreateDebugUtilsMessengerEXT_(VkInstance instance,
                                         const VkDebugUtilsMessengerCreateInfoEXT* info,
                                         const VkAllocationCallbacks* allocator,
                                         VkDebugUtilsMessengerEXT* messenger) {
    return reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(::vkGetInstanceProcAddr(
        instance, "vkCreateDebugUtilsMessengerEXT"))(instance, info, allocator, messenger);
}
void vkDestroyDebugUtilsMessengerEXT_(VkInstance instance, VkDebugUtilsMessengerEXT messenger,
                                      const VkAllocationCallbacks* allocator) {
    reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(::vkGetInstanceProcAddr(
        instance, "vkDestroyDebugUtilsMessengerEXT"))(instance, messenger, allocator);
}

// Outputs of a failed call are undefined: nobody may use them.
template <class Last>
void poison(Last last) {
    if constexpr (std::is_pointer_v<Last>) {
        using Target = std::remove_pointer_t<Last>;
        if constexpr (std::is_pointer_v<Target> && !std::is_const_v<Target>)
            if (last) std::memset(last, 0xdd, sizeof *last);
    }
}

template <Call id, class... Arguments>
VkResult fail(VkResult code, VkResult (*real)(Arguments...), Arguments... arguments) {
    const auto all = std::tie(arguments...);
    // A lost device has taken the work, and ends it; waiting for all is the last resort of who
    // could not wait otherwise; a list that is not complete is a list.
    constexpr bool takes = id == Call::vkQueueSubmit || id == Call::vkWaitForFences;
    if ((takes && code == VK_ERROR_DEVICE_LOST) || id == Call::vkDeviceWaitIdle ||
        code == VK_INCOMPLETE) {
        std::ignore = real(arguments...);
        VulkanShim::get().running = id == Call::vkQueueSubmit;
        return code;
    }
    if constexpr (id == Call::vkGetQueryPoolResults)
        std::memset(std::get<5>(all), 0xdd, std::get<4>(all));
    else if constexpr (id != Call::vkEnumeratePhysicalDevices)
        poison(std::get<sizeof...(Arguments) - 1>(all));
    return code;
}

template <Call id, class... Arguments>
void record_success(VulkanShim& shim, Arguments... arguments) {
    const auto all = std::tie(arguments...);
    if constexpr (requires { shim.audit.see(Seen<id>{}, arguments...); })
        shim.audit.see(Seen<id>{}, arguments...);
    constexpr std::string_view name = name_in_type(id);
    if constexpr (name.starts_with("vkCreate") || id == Call::vkAllocateMemory)
        shim.census.born(*std::get<sizeof...(Arguments) - 1>(all));
    if constexpr (name.starts_with("vkDestroy") || id == Call::vkFreeMemory) {
        shim.census.died(std::get<sizeof...(Arguments) - 2>(all));
        shim.died_in_use += shim.running;
    }
    if constexpr (id == Call::vkQueueSubmit) shim.running = true;
    if constexpr (id == Call::vkWaitForFences || id == Call::vkDeviceWaitIdle) shim.running = false;
    if constexpr (id == Call::vkCreateShaderModule)
        shim.pipelines.shader_made(*std::get<1>(all), *std::get<3>(all));
    if constexpr (id == Call::vkGetPhysicalDeviceProperties2)
        if (shim.spoof.properties) shim.spoof.properties(std::get<1>(all)->properties);
    if constexpr (id == Call::vkGetPhysicalDeviceMemoryProperties)
        if (shim.spoof.memory) shim.spoof.memory(*std::get<1>(all));
    if constexpr (id == Call::vkGetPhysicalDeviceFormatProperties)
        if (shim.spoof.format) shim.spoof.format(std::get<1>(all), *std::get<2>(all));
    if constexpr (id == Call::vkGetPhysicalDeviceQueueFamilyProperties)
        if (shim.spoof.queue_family && std::get<2>(all))
            std::for_each_n(std::get<2>(all), *std::get<1>(all), shim.spoof.queue_family);
}

template <Call id, class R, class... Arguments>
R perform(VulkanShim& shim, R (*real)(Arguments...), Arguments... arguments) {
    const auto all = std::tie(arguments...);
    if constexpr (id == Call::vkCreateComputePipelines || id == Call::vkCreateGraphicsPipelines)
        return shim.pipelines.make(std::get<0>(all), *std::get<3>(all), *std::get<5>(all),
                                   [&] { return real(arguments...); });
    if constexpr (id == Call::vkDestroyPipeline)
        if (shim.pipelines.keeps(std::get<0>(all), std::get<1>(all))) return;
    if constexpr (id == Call::vkCmdDispatch || id == Call::vkCmdDispatchBase ||
                  id == Call::vkCmdDraw)
        if (shim.dry) return;
    if constexpr (id == Call::vkDestroyDevice) shim.pipelines.device_dies(std::get<0>(all));
    return real(arguments...);
}

struct Inside {
    Inside() { VulkanShim::inside = true; }
    ~Inside() { VulkanShim::inside = false; }
};

template <Call id, auto real>
struct Wrapped;
template <Call id, class R, class... Arguments, R (*real)(Arguments...)>
struct Wrapped<id, real> {
    static R call(Arguments... arguments) {
        const Inside inside;
        VulkanShim& shim = VulkanShim::get();
        if constexpr (std::is_same_v<R, VkResult>) {
            if (const auto code = shim.faults.answer(id))
                return fail<id>(*code, real, arguments...);
            const VkResult code = perform<id>(shim, real, arguments...);
            if (code >= 0) record_success<id>(shim, arguments...);
            return code;
        } else {
            perform<id>(shim, real, arguments...);
            record_success<id>(shim, arguments...);
        }
    }
};

struct Entry {
    std::string_view name;
    PFN_vkVoidFunction function;
};

template <Call id, auto real>
PFN_vkVoidFunction wrapped() {
    return reinterpret_cast<PFN_vkVoidFunction>(&Wrapped<id, real>::call);
}

PFN_vkVoidFunction find(const char* wanted, bool instance) {
    static const Entry of_instances[] = {
#define X(name, ...) {#name, wrapped<Call::name, &::name>()},
        LOBELIA_SHIM_INSTANCE_FUNCTIONS(X)
#undef X
#define X(name, ...) {#name, wrapped<Call::name, &name##_>()},
            LOBELIA_SHIM_EXTENSION_FUNCTIONS(X)
#undef X
    };
    static const Entry of_devices[] = {
#define X(name, ...) {#name, wrapped<Call::name, &::name>()},
        LOBELIA_SHIM_DEVICE_FUNCTIONS(X)
#undef X
    };
    VulkanShim& shim = VulkanShim::get();
    if (shim.spoof.hidden.contains(wanted)) return nullptr;
    for (const Entry& entry : instance ? std::span<const Entry>(of_instances) : of_devices)
        if (entry.name == wanted) return entry.function;
    shim.unknown.insert(wanted);
    return nullptr;
}

PFN_vkVoidFunction get_device_proc_addr(VkDevice device, const char* name) {
    const Inside inside;
    const PFN_vkVoidFunction real = ::vkGetDeviceProcAddr(device, name);
    // Names and labels for debuggers change nothing, and are there with the layers alone.
    if (std::string_view(name).find("DebugUtils") != std::string_view::npos) return real;
    return real ? find(name, false) : nullptr;
}

PFN_vkVoidFunction get_instance_proc_addr(VkInstance instance, const char* name) {
    const Inside inside;
    const PFN_vkVoidFunction real = ::vkGetInstanceProcAddr(instance, name);
    if (!real) return nullptr;
    if (name == std::string_view("vkGetInstanceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&get_instance_proc_addr);
    if (name == std::string_view("vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&get_device_proc_addr);
    return find(name, true);
}

} // namespace

VulkanShim& VulkanShim::get() {
    static VulkanShim one;
    return one;
}

PFN_vkGetInstanceProcAddr VulkanShim::entry() {
    return &get_instance_proc_addr;
}

} // namespace lobelia::test
