#include <lobelia/host/gpu.h>

#include <algorithm>
#include <cstring>

#include "host/gpu_instance.h"
#include "host/gpu_memory.h"
#include "host/guard.h"
#include "host/timestamps.h"

namespace lobelia::host {

namespace {

// Waiting for a fence makes nothing visible to the host.
void record_host_read(const DeviceFunctions& call, VkCommandBuffer commands) {
    const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                  .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
                                  .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    call.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                              VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

constexpr std::uint64_t WAIT_NANOSECONDS = 60'000'000'000; // a dispatch is sized to take 0.1 s
constexpr const char* SWAPCHAIN = VK_KHR_SWAPCHAIN_EXTENSION_NAME;

} // namespace

struct Gpu::State {
    std::unique_ptr<Instance> instance;
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    GpuDescription description;
    std::string why_picked;
    VkPhysicalDeviceLimits limits{};
    MemoryAccount memory;
    HostContext context;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    HostObject<VkCommandPool, &DeviceFunctions::vkDestroyCommandPool> pool;
    HostObject<VkFence, &DeviceFunctions::vkDestroyFence> fence;
    Timestamps timestamps;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    bool lost = false; // nothing can be submitted any more

    ~State() {
        if (!context.device.handle) return;
        if (context.call.vkDeviceWaitIdle) context.call.vkDeviceWaitIdle(context.device.handle);
        timestamps = {};
        fence = {};
        pool = {};
        if (context.call.vkDestroyDevice)
            context.call.vkDestroyDevice(context.device.handle, nullptr);
    }

    Outcome<Done> open(const GpuOptions& options);
    Outcome<Done> make_device();
    Outcome<Done> make_command_buffer();
    Outcome<Done> submit(const std::function<void(VkCommandBuffer)>& record);
    void settle(VkResult code);
};

Outcome<Done> Gpu::State::open(const GpuOptions& options) {
    auto created = Instance::create(options);
    if (!created) return created.error();
    instance = std::move(*created);

    const auto choice = choose(*instance, options.device);
    if (!choice) return choice.error();
    physical_device = choice->device;
    why_picked = choice->why;
    description = describe(*instance, physical_device);
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    instance->call.vkGetPhysicalDeviceProperties2(physical_device, &properties);
    limits = properties.properties.limits;
    memory = open_memory_account(*instance, physical_device, options.memory_bytes);
    return make_device();
}

Outcome<Done> Gpu::State::make_device() {
    std::uint32_t count = 0;
    instance->call.vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    instance->call.vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count,
                                                            families.data());
    const auto serves = [&](std::uint32_t index) {
        const VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
        return (families[index].queueFlags & needed) == needed &&
               instance->can_present(physical_device, index);
    };
    while (queue_family < count && !serves(queue_family)) ++queue_family;
    if (queue_family == count)
        return Failure{description.name + " has no queue for graphics and compute" +
                       (instance->surface ? " that can show pictures in this window" : "") +
                       ", pick another device"};

    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue_info{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                             .queueFamilyIndex = queue_family,
                                             .queueCount = 1,
                                             .pQueuePriorities = &priority};
    const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                  .queueCreateInfoCount = 1,
                                  .pQueueCreateInfos = &queue_info,
                                  .enabledExtensionCount = instance->surface ? 1u : 0u,
                                  .ppEnabledExtensionNames = &SWAPCHAIN};
    VkDevice handle = VK_NULL_HANDLE;
    const VkResult code = instance->call.vkCreateDevice(physical_device, &info, nullptr, &handle);
    if (code != VK_SUCCESS) return failed("create a device", code);
    context.device = {.handle = handle, .get_device_proc_addr = instance->call.vkGetDeviceProcAddr};
#define X(name)                                                                                    \
    context.call.name =                                                                            \
        reinterpret_cast<PFN_##name>(instance->call.vkGetDeviceProcAddr(handle, #name));           \
    if (!context.call.name) return Failure{"the Vulkan driver has no " #name ", update it"};
    LOBELIA_HOST_DEVICE_FUNCTIONS(X)
#undef X
    context.call.vkGetDeviceQueue(handle, queue_family, 0, &queue);
    auto made = Timestamps::create(context, families[queue_family].timestampValidBits,
                                   limits.timestampPeriod);
    if (!made) return made.error();
    timestamps = std::move(*made);
    return make_command_buffer();
}

Outcome<Done> Gpu::State::make_command_buffer() {
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .queueFamilyIndex = queue_family};
    VkCommandPool pool_handle = VK_NULL_HANDLE;
    VkResult code =
        context.call.vkCreateCommandPool(context.device.handle, &pool_info, nullptr, &pool_handle);
    if (code != VK_SUCCESS) return failed("create a command pool", code);
    pool = {context, pool_handle};

    const VkCommandBufferAllocateInfo allocation{.sType =
                                                     VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                 .commandPool = pool_handle,
                                                 .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                 .commandBufferCount = 1};
    code = context.call.vkAllocateCommandBuffers(context.device.handle, &allocation, &commands);
    if (code != VK_SUCCESS) return failed("allocate a command buffer", code);

    const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkFence fence_handle = VK_NULL_HANDLE;
    code = context.call.vkCreateFence(context.device.handle, &fence_info, nullptr, &fence_handle);
    if (code != VK_SUCCESS) return failed("create a fence", code);
    fence = {context, fence_handle};
    return Done{};
}

Outcome<std::vector<GpuDescription>> list_gpus(const GpuOptions& options) {
    return guarded([&]() -> Outcome<std::vector<GpuDescription>> {
        const auto instance = Instance::create(options);
        if (!instance) return instance.error();
        std::vector<GpuDescription> all;
        for (const VkPhysicalDevice device : (*instance)->physical_devices)
            all.push_back(describe(**instance, device));
        return all;
    });
}

Outcome<Gpu> Gpu::create(const GpuOptions& options) {
    return guarded([&]() -> Outcome<Gpu> {
        auto state = std::make_unique<State>();
        if (const auto opened = state->open(options); !opened) return opened.error();
        return Gpu(std::move(state));
    });
}

Gpu::Gpu(std::unique_ptr<State> state) : state_(std::move(state)) {}
Gpu::Gpu(Gpu&&) noexcept = default;
Gpu& Gpu::operator=(Gpu&&) noexcept = default;
Gpu::~Gpu() = default;

const Device& Gpu::device() const {
    return state_->context.device;
}
VkInstance Gpu::instance() const {
    return state_->instance->handle;
}
VkPhysicalDevice Gpu::physical_device() const {
    return state_->physical_device;
}
VkQueue Gpu::queue() const {
    return state_->queue;
}
std::uint32_t Gpu::queue_family() const {
    return state_->queue_family;
}
VkSurfaceKHR Gpu::surface() const {
    return state_->instance->surface;
}
PFN_vkGetInstanceProcAddr Gpu::get_instance_proc_addr() const {
    return state_->instance->get_instance_proc_addr;
}
const GpuDescription& Gpu::description() const {
    return state_->description;
}
const std::string& Gpu::why_picked() const {
    return state_->why_picked;
}
const VkPhysicalDeviceLimits& Gpu::limits() const {
    return state_->limits;
}
std::vector<std::string> Gpu::take_messages() {
    return std::exchange(state_->instance->messages, {});
}

Outcome<GpuBuffer> Gpu::create_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, Memory memory) {
    return guarded(
        [&] { return make_buffer(state_->context, state_->memory, bytes, usage, memory); });
}

Outcome<GpuImage> Gpu::create_image(const GpuImageDescription& description) {
    return guarded(
        [&] { return make_image(state_->context, state_->memory, state_->limits, description); });
}

// What was submitted must have ended before the caller destroys what it uses, even where `code`
// said that this cannot be known. A lost device has taken the work that it refuses, and ends it.
void Gpu::State::settle(VkResult code) {
    const VkResult ended = context.call.vkDeviceWaitIdle(context.device.handle);
    lost = code == VK_ERROR_DEVICE_LOST || ended != VK_SUCCESS;
}

Outcome<Done> Gpu::State::submit(const std::function<void(VkCommandBuffer)>& record) {
    const DeviceFunctions& call = context.call;
    const VkDevice device = context.device.handle;
    const VkFence submitted = fence.get();
    if (lost) return Failure{"the Vulkan device is lost, open it again"};

    VkResult code = call.vkResetCommandPool(device, pool.get(), 0);
    if (code != VK_SUCCESS) return failed("reset the command pool", code);
    const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                         .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    code = call.vkBeginCommandBuffer(commands, &begin);
    if (code != VK_SUCCESS) return failed("begin a command buffer", code);
    record(commands);
    record_host_read(call, commands);
    code = call.vkEndCommandBuffer(commands);
    if (code != VK_SUCCESS) return failed("end a command buffer", code);

    code = call.vkResetFences(device, 1, &submitted);
    if (code != VK_SUCCESS) return failed("reset a fence", code);
    const VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                            .commandBufferCount = 1,
                            .pCommandBuffers = &commands};
    code = call.vkQueueSubmit(queue, 1, &info, submitted);
    if (code == VK_ERROR_DEVICE_LOST) settle(code);
    if (code != VK_SUCCESS) return failed("submit commands", code);
    code = call.vkWaitForFences(device, 1, &submitted, VK_TRUE, WAIT_NANOSECONDS);
    if (code == VK_SUCCESS) return Done{};
    settle(code);
    return failed("finish the submitted commands", code);
}

Outcome<Done> Gpu::submit(const std::function<void(VkCommandBuffer)>& record) {
    return guarded([&] { return state_->submit(record); });
}

Outcome<std::optional<double>>
Gpu::submit_timed(const std::function<void(VkCommandBuffer)>& record) {
    const Timestamps& timestamps = state_->timestamps;
    const auto done = submit([&](VkCommandBuffer commands) {
        timestamps.record_begin(commands);
        record(commands);
        timestamps.record_end(commands);
    });
    if (!done) return done.error();
    return timestamps.milliseconds();
}

Outcome<Done> Gpu::upload(const Image& source, const GpuImage& target) {
    return upload_rows(source, target, 0, source.layers * source.height);
}

Outcome<Done> Gpu::upload_rows(const Image& source, const GpuImage& target, std::uint32_t first,
                               std::uint32_t count) {
    const std::size_t row = std::size_t(4) * source.width; // floats
    const VkDeviceSize bytes = row * count * sizeof(float);
    auto staging = create_buffer(bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Memory::host);
    if (!staging) return staging.error();
    std::memcpy(staging->data(), &source.texels[row * first], bytes);
    return submit([&](VkCommandBuffer commands) {
        if (first == 0)
            record_layout_change(*this, commands, target, VK_IMAGE_LAYOUT_UNDEFINED,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const std::vector<VkBufferImageCopy> copies = rows_of_layers(target, first, count);
        state_->context.call.vkCmdCopyBufferToImage(commands, staging->handle(), target.handle(),
                                                    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                                    std::uint32_t(copies.size()), copies.data());
        if (first + count == source.layers * source.height)
            record_layout_change(*this, commands, target, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    });
}

Outcome<Image> Gpu::download(const GpuImage& source, VkImageLayout layout, std::uint32_t level) {
    const GpuImageDescription& shape = source.description();
    const VkBufferImageCopy copy = whole_level(source, level);
    const std::size_t count =
        std::size_t(4) * copy.imageExtent.width * copy.imageExtent.height * shape.layers;
    const bool half = shape.format == VK_FORMAT_R16G16B16A16_SFLOAT;
    auto staging =
        create_buffer(count * (half ? 2 : 4), VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::host);
    if (!staging) return staging.error();
    const auto copied = submit([&](VkCommandBuffer commands) {
        record_layout_change(*this, commands, source, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        state_->context.call.vkCmdCopyImageToBuffer(commands, source.handle(),
                                                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                                    staging->handle(), 1, &copy);
        record_layout_change(*this, commands, source, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
    });
    if (!copied) return copied.error();

    return guarded([&]() -> Outcome<Image> {
        Image image{shape.cube ? Layout::cube : Layout::latlong, copy.imageExtent.width,
                    copy.imageExtent.height, shape.layers, std::vector<float>(count)};
        if (half)
            widen_halves(staging->data(), image.texels);
        else
            std::memcpy(image.texels.data(), staging->data(), count * sizeof(float));
        return image;
    });
}

void record_layout_change(const Gpu& gpu, VkCommandBuffer commands, const GpuImage& image,
                          VkImageLayout from, VkImageLayout to) {
    const VkImageMemoryBarrier barrier{
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
        .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
        .dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image.handle(),
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0,
                             VK_REMAINING_ARRAY_LAYERS}};
    const auto record = reinterpret_cast<PFN_vkCmdPipelineBarrier>(
        gpu.device().get_device_proc_addr(gpu.device().handle, "vkCmdPipelineBarrier"));
    record(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
           nullptr, 0, nullptr, 1, &barrier);
}

} // namespace lobelia::host
