#include "host/gpu_instance.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include <vulkan/vulkan.h>

namespace lobelia::host {

namespace {

std::string result_name(VkResult code) {
    switch (code) {
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED: return "initialisation failed";
    case VK_ERROR_DEVICE_LOST: return "device lost";
    case VK_ERROR_MEMORY_MAP_FAILED: return "mapping memory failed";
    case VK_ERROR_LAYER_NOT_PRESENT: return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "no compatible driver";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "format not supported";
    case VK_ERROR_VALIDATION_FAILED_EXT: return "not allowed";
    case VK_TIMEOUT: return "timeout";
    default: return "VkResult " + std::to_string(int(code));
    }
}

} // namespace

Failure failed(const std::string& step, VkResult code) {
    return Failure{"Vulkan could not " + step + " (" + result_name(code) + ")"};
}

namespace {

constexpr const char* VALIDATION_LAYER = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                                            void* messages) {
    // The loader reports which layers it loads through the same channel.
    if (data->pMessageIdName && std::strcmp(data->pMessageIdName, "Loader Message") == 0)
        return VK_FALSE;
    static_cast<std::vector<std::string>*>(messages)->push_back(data->pMessage);
    return VK_FALSE;
}

const char* type_name(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return "cpu";
    default: return "other";
    }
}

} // namespace

Outcome<std::unique_ptr<Instance>> Instance::create(const GpuOptions& options) {
    auto instance = std::make_unique<Instance>();
    if (const auto started = instance->start(options); !started) return started.error();
    return instance;
}

Outcome<Done> Instance::start(const GpuOptions& options) {
    get_instance_proc_addr =
        options.get_instance_proc_addr ? options.get_instance_proc_addr : &::vkGetInstanceProcAddr;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(
        get_instance_proc_addr(VK_NULL_HANDLE, "vkCreateInstance"));
    if (!create) return Failure{"the Vulkan loader has no vkCreateInstance, install a newer one"};

    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .pApplicationName = "lobelia",
                                        .apiVersion = VK_API_VERSION_1_1};
    const VkValidationFeatureEnableEXT synchronisation =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .enabledValidationFeatureCount = 1,
                                           .pEnabledValidationFeatures = &synchronisation};
    std::vector<const char*> extensions;
    if (options.presentation) extensions = options.presentation->instance_extensions;
    VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                              .pApplicationInfo = &application};
    if (options.validation) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &VALIDATION_LAYER;
    }
    info.enabledExtensionCount = std::uint32_t(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VkInstance created = VK_NULL_HANDLE;
    if (const VkResult code = create(&info, nullptr, &created); code != VK_SUCCESS)
        return failed("create an instance", code);
    handle = created;

#define X(name)                                                                                    \
    call.name = reinterpret_cast<PFN_##name>(get_instance_proc_addr(handle, #name));               \
    if (!call.name) return Failure{"the Vulkan loader has no " #name ", install a newer one"};
    LOBELIA_HOST_INSTANCE_FUNCTIONS(X)
#undef X
    if (options.validation)
        if (const auto listening = listen(); !listening) return listening.error();
    if (options.presentation)
        if (const auto made = make_surface(*options.presentation); !made) return made.error();

    std::uint32_t count = 0;
    VkResult code = call.vkEnumeratePhysicalDevices(handle, &count, nullptr);
    if (code == VK_SUCCESS && count > 0) {
        physical_devices.resize(count);
        code = call.vkEnumeratePhysicalDevices(handle, &count, physical_devices.data());
        physical_devices.resize(count);
    }
    if (code != VK_SUCCESS) return failed("list the devices", code);
    if (physical_devices.empty())
        return Failure{"no Vulkan device found, install a driver (mesa-vulkan-drivers has one "
                       "that needs no GPU)"};
    return Done{};
}

Outcome<Done> Instance::listen() {
    const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        get_instance_proc_addr(handle, "vkCreateDebugUtilsMessengerEXT"));
    destroy_messenger_ = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        get_instance_proc_addr(handle, "vkDestroyDebugUtilsMessengerEXT"));
    if (!create)
        return Failure{"the Vulkan loader has no vkCreateDebugUtilsMessengerEXT, install a newer "
                       "one"};
    if (!destroy_messenger_)
        return Failure{"the Vulkan loader has no vkDestroyDebugUtilsMessengerEXT, install a newer "
                       "one"};
    const VkDebugUtilsMessengerCreateInfoEXT info{
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT,
        .pfnUserCallback = keep_message,
        .pUserData = &messages};
    VkDebugUtilsMessengerEXT created = VK_NULL_HANDLE;
    const VkResult code = create(handle, &info, nullptr, &created);
    if (code != VK_SUCCESS) return failed("listen to validation", code);
    messenger_ = created;
    return Done{};
}

Outcome<Done> Instance::make_surface(const Presentation& presentation) {
    const VkResult code = presentation.make_surface(handle, &surface);
    if (code != VK_SUCCESS) return failed("make a surface of the window", code);
    return Done{};
}

bool Instance::can_present(VkPhysicalDevice device, std::uint32_t queue_family) const {
    if (!surface) return true;
    const auto ask = reinterpret_cast<PFN_vkGetPhysicalDeviceSurfaceSupportKHR>(
        get_instance_proc_addr(handle, "vkGetPhysicalDeviceSurfaceSupportKHR"));
    VkBool32 supported = VK_FALSE;
    return ask && ask(device, queue_family, surface, &supported) == VK_SUCCESS && supported;
}

Instance::~Instance() {
    if (surface)
        reinterpret_cast<PFN_vkDestroySurfaceKHR>(
            get_instance_proc_addr(handle, "vkDestroySurfaceKHR"))(handle, surface, nullptr);
    if (messenger_) destroy_messenger_(handle, messenger_, nullptr);
    if (handle && call.vkDestroyInstance) call.vkDestroyInstance(handle, nullptr);
}

GpuDescription describe(const Instance& instance, VkPhysicalDevice device) {
    VkPhysicalDeviceDriverProperties driver{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                           .pNext = &driver};
    instance.call.vkGetPhysicalDeviceProperties2(device, &properties);
    return {properties.properties.deviceName,
            std::string(driver.driverName) + " " + driver.driverInfo,
            type_name(properties.properties.deviceType), properties.properties.apiVersion};
}

namespace {

int rank(const std::string& type) {
    const char* const best_first[] = {"discrete", "integrated", "virtual", "cpu"};
    return int(std::find(std::begin(best_first), std::end(best_first), type) - best_first);
}

} // namespace

Outcome<Choice> choose(const Instance& instance, const std::string& wanted) {
    std::vector<GpuDescription> all;
    for (const VkPhysicalDevice device : instance.physical_devices)
        all.push_back(describe(instance, device));

    if (wanted.empty()) {
        const auto best =
            std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
                return rank(a.type) < rank(b.type);
            });
        return Choice{instance.physical_devices[std::size_t(best - all.begin())],
                      "the first " + best->type +
                          " device, in the order discrete, integrated, "
                          "virtual, cpu"};
    }
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error == std::errc() && end == wanted.data() + wanted.size() && index < all.size())
        return Choice{instance.physical_devices[index], "asked for by its index " + wanted};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name.find(wanted) != std::string::npos)
            return Choice{instance.physical_devices[i], "asked for by its name '" + wanted + "'"};

    std::string message = "no Vulkan device is called or numbered '" + wanted + "'; there are:";
    for (std::size_t i = 0; i < all.size(); ++i)
        message += " " + std::to_string(i) + " " + all[i].name + ";";
    message.back() = '.';
    return Failure{message};
}

} // namespace lobelia::host
