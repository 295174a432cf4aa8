#include "engine.h"

#include <cstdio>
#include <cstdlib>

void fail(const char* what) {
    std::fprintf(stderr, "could not %s\n", what);
    std::exit(1);
}

void check(VkResult code, const char* what) {
    if (code != VK_SUCCESS) fail(what);
}

Engine Engine::create(std::uint32_t version, const void* features,
                      std::uint32_t (*also)(const Engine&)) {
    Engine engine;
    check(volkInitialize(), "find Vulkan");
    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .apiVersion = version};
    const VkInstanceCreateInfo instance{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
    check(vkCreateInstance(&instance, nullptr, &engine.instance), "create an instance");
    volkLoadInstance(engine.instance);
    std::uint32_t one = 1;
    if (vkEnumeratePhysicalDevices(engine.instance, &one, &engine.physical) < 0 || one == 0)
        fail("find a device");

    const float priority = 1;
    VkDeviceQueueCreateInfo queues[2] = {{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                          .queueFamilyIndex = engine.family,
                                          .queueCount = 1,
                                          .pQueuePriorities = &priority}};
    queues[1] = queues[0];
    if (also) queues[1].queueFamilyIndex = also(engine);
    const VkDeviceCreateInfo device{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                    .pNext = features,
                                    .queueCreateInfoCount =
                                        queues[1].queueFamilyIndex != engine.family ? 2u : 1u,
                                    .pQueueCreateInfos = queues};
    check(vkCreateDevice(engine.physical, &device, nullptr, &engine.device), "create a device");
    vkGetDeviceQueue(engine.device, engine.family, 0, &engine.queue);
    engine.make_pool();
    return engine;
}

void Engine::make_pool() {
    const VkCommandPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                       .queueFamilyIndex = family};
    check(vkCreateCommandPool(device, &info, nullptr, &pool), "create a command pool");
}

void Engine::destroy() {
    vkDestroyCommandPool(device, pool, nullptr);
    vkDestroyDevice(device, nullptr);
    vkDestroyInstance(instance, nullptr);
}

VkDeviceMemory Engine::allocate(const VkMemoryRequirements& needed,
                                VkMemoryPropertyFlags kind) const {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    std::uint32_t type = 0;
    while (!(needed.memoryTypeBits >> type & 1) ||
           (memory.memoryTypes[type].propertyFlags & kind) != kind)
        if (++type == memory.memoryTypeCount) fail("find memory of a kind");
    const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                    .allocationSize = needed.size,
                                    .memoryTypeIndex = type};
    VkDeviceMemory allocated = VK_NULL_HANDLE;
    check(vkAllocateMemory(device, &info, nullptr, &allocated), "allocate memory");
    return allocated;
}

Image Engine::make_image(const ImageShape& shape) const {
    const bool cube = shape.view == VK_IMAGE_VIEW_TYPE_CUBE;
    const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                 .flags = cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT
                                               : VkImageCreateFlagBits{},
                                 .imageType = VK_IMAGE_TYPE_2D,
                                 .format = shape.format,
                                 .extent = {shape.width, shape.height, 1},
                                 .mipLevels = 1,
                                 .arrayLayers = shape.layers,
                                 .samples = VK_SAMPLE_COUNT_1_BIT,
                                 .usage = shape.usage};
    Image image;
    check(vkCreateImage(device, &info, nullptr, &image.handle), "create an image");
    VkMemoryRequirements needed;
    vkGetImageMemoryRequirements(device, image.handle, &needed);
    image.memory = allocate(needed, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkBindImageMemory(device, image.handle, image.memory, 0), "bind an image's memory");
    const VkImageAspectFlags aspect = shape.format == VK_FORMAT_D32_SFLOAT
                                          ? VK_IMAGE_ASPECT_DEPTH_BIT
                                          : VK_IMAGE_ASPECT_COLOR_BIT;
    const VkImageViewCreateInfo view{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     .image = image.handle,
                                     .viewType = shape.view,
                                     .format = shape.format,
                                     .subresourceRange = {aspect, 0, 1, 0, shape.layers}};
    check(vkCreateImageView(device, &view, nullptr, &image.view), "create a view");
    return image;
}

Buffer Engine::make_buffer(VkDeviceSize size, VkBufferUsageFlags usage) const {
    const VkBufferCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    Buffer buffer;
    check(vkCreateBuffer(device, &info, nullptr, &buffer.handle), "create a buffer");
    VkMemoryRequirements needed;
    vkGetBufferMemoryRequirements(device, buffer.handle, &needed);
    buffer.memory = allocate(needed, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                         VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(device, buffer.handle, buffer.memory, 0), "bind a buffer's memory");
    check(vkMapMemory(device, buffer.memory, 0, VK_WHOLE_SIZE, 0, &buffer.data), "map memory");
    return buffer;
}

void Engine::destroy(const Image& image) const {
    vkDestroyImageView(device, image.view, nullptr);
    vkDestroyImage(device, image.handle, nullptr);
    vkFreeMemory(device, image.memory, nullptr);
}

void Engine::destroy(const Buffer& buffer) const {
    vkDestroyBuffer(device, buffer.handle, nullptr);
    vkFreeMemory(device, buffer.memory, nullptr);
}

VkCommandBuffer Engine::begin() const {
    const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                           .commandPool = pool,
                                           .commandBufferCount = 1};
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device, &info, &commands), "allocate a command buffer");
    const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    check(vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
    return commands;
}

void Engine::submit_and_wait(VkCommandBuffer commands) const {
    check(vkEndCommandBuffer(commands), "end a command buffer");
    const VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                            .commandBufferCount = 1,
                            .pCommandBuffers = &commands};
    check(vkQueueSubmit(queue, 1, &info, VK_NULL_HANDLE), "submit commands");
    check(vkQueueWaitIdle(queue), "wait for the device");
    vkFreeCommandBuffers(device, pool, 1, &commands);
}
