#pragma once

#include <cstdint>
#include <cstring>

#include <lobelia/host/gpu.h>

namespace lobelia::test {

/// What the core has recorded by a counting device since the last reset, on one thread.
struct Recorded {
    std::uint64_t dispatches = 0;
    std::uint64_t groups = 0;
    std::uint64_t draws = 0;
    std::uint64_t barriers = 0;

    static Recorded& now() {
        static Recorded recorded;
        return recorded;
    }
    static void reset() { now() = {}; }
};

namespace counting {

inline PFN_vkGetDeviceProcAddr next = nullptr;
inline PFN_vkCmdDispatch dispatch = nullptr;
inline PFN_vkCmdDispatchBase dispatch_base = nullptr;
inline PFN_vkCmdDraw draw = nullptr;
inline PFN_vkCmdPipelineBarrier barrier = nullptr;

inline void count_groups(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    ++Recorded::now().dispatches;
    Recorded::now().groups += std::uint64_t(x) * y * z;
}

inline VKAPI_ATTR void VKAPI_CALL count_dispatch(VkCommandBuffer commands, std::uint32_t x,
                                                 std::uint32_t y, std::uint32_t z) {
    count_groups(x, y, z);
    dispatch(commands, x, y, z);
}

inline VKAPI_ATTR void VKAPI_CALL count_dispatch_base(VkCommandBuffer commands,
                                                      std::uint32_t first_x, std::uint32_t first_y,
                                                      std::uint32_t first_z, std::uint32_t x,
                                                      std::uint32_t y, std::uint32_t z) {
    count_groups(x, y, z);
    dispatch_base(commands, first_x, first_y, first_z, x, y, z);
}

inline VKAPI_ATTR void VKAPI_CALL count_draw(VkCommandBuffer commands, std::uint32_t vertices,
                                             std::uint32_t instances, std::uint32_t first_vertex,
                                             std::uint32_t first_instance) {
    ++Recorded::now().draws;
    draw(commands, vertices, instances, first_vertex, first_instance);
}

inline VKAPI_ATTR void VKAPI_CALL
count_barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
              VkDependencyFlags flags, std::uint32_t memory_count, const VkMemoryBarrier* memory,
              std::uint32_t buffer_count, const VkBufferMemoryBarrier* buffers,
              std::uint32_t image_count, const VkImageMemoryBarrier* images) {
    ++Recorded::now().barriers;
    barrier(commands, from, to, flags, memory_count, memory, buffer_count, buffers, image_count,
            images);
}

/// The device's own function, kept in `real`, or `mine` in its place.
template <class Function>
PFN_vkVoidFunction replace(PFN_vkVoidFunction found, Function& real, Function mine) {
    real = reinterpret_cast<Function>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(mine);
}

inline VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL look_up(VkDevice device, const char* name) {
    const PFN_vkVoidFunction found = next(device, name);
    const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
    if (is("vkCmdDispatch")) return replace(found, dispatch, &count_dispatch);
    if (is("vkCmdDispatchBase")) return replace(found, dispatch_base, &count_dispatch_base);
    if (is("vkCmdDraw")) return replace(found, draw, &count_draw);
    if (is("vkCmdPipelineBarrier")) return replace(found, barrier, &count_barrier);
    return found;
}

inline VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL look_up_instance(VkInstance instance,
                                                                 const char* name) {
    const PFN_vkVoidFunction found = vkGetInstanceProcAddr(instance, name);
    if (std::strcmp(name, "vkGetDeviceProcAddr") != 0) return found;
    return replace(found, next, &look_up);
}

} // namespace counting

/// The device, counting what the core records with it.
inline Device counting_device(const host::Gpu& gpu) {
    Device device = gpu.device();
    counting::next = device.get_device_proc_addr;
    device.get_device_proc_addr = &counting::look_up;
    return device;
}

/// A device of the host whose core counts.
inline host::GpuOptions counting_options() {
    return {.validation = true, .get_instance_proc_addr = &counting::look_up_instance};
}

} // namespace lobelia::test
