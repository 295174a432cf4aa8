#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>

#include <gtest/gtest.h>

#include <lobelia/cube_to_cube.h>
#include <lobelia/prefilter.h>
#include <lobelia/sky.h>

#include "support/gpu_sources.h"

// What the driver takes of the host's memory through Device::allocator.
namespace lobelia::test {
namespace {

/// Callbacks of which one call gives nothing.
class Callbacks {
public:
    explicit Callbacks(std::size_t failing) : failing_(failing) {}

    const VkAllocationCallbacks* get() const { return &callbacks_; }
    std::size_t calls() const { return calls_; } // that asked for memory
    std::size_t live() const { return sizes_.size(); }

private:
    void* allocate(std::size_t size, std::size_t alignment) {
        const std::lock_guard lock(mutex_);
        if (calls_++ == failing_) return nullptr;
        void* const memory =
            std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        sizes_[memory] = size;
        return memory;
    }
    void* reallocate(void* old, std::size_t size, std::size_t alignment) {
        void* const memory = allocate(size, alignment);
        if (memory && old) {
            std::memcpy(memory, old, std::min(size, sizes_.at(old)));
            release(old);
        }
        return memory;
    }
    void release(void* memory) {
        const std::lock_guard lock(mutex_);
        EXPECT_EQ(sizes_.erase(memory), memory != nullptr);
        std::free(memory);
    }

    static Callbacks& of(void* self) { return *static_cast<Callbacks*>(self); }

    std::size_t failing_, calls_ = 0;
    std::map<void*, std::size_t> sizes_; // of what is alive
    std::mutex mutex_;
    VkAllocationCallbacks callbacks_{
        .pUserData = this,
        .pfnAllocation = [](void* self, std::size_t size, std::size_t alignment,
                            VkSystemAllocationScope) { return of(self).allocate(size, alignment); },
        .pfnReallocation =
            [](void* self, void* old, std::size_t size, std::size_t alignment,
               VkSystemAllocationScope) { return of(self).reallocate(old, size, alignment); },
        .pfnFree = [](void* self, void* memory) { of(self).release(memory); }};
};

struct Targets {
    host::GpuImage source, cube, panorama;
};

/// Makes objects of most kinds, and lets them go.
Result<SkyJob> make_objects(const Device& device, const Targets& targets) {
    if (const auto made = Prefilter::create(device); !made) return made.error();
    const auto resampling = CubeToCube::create(device);
    if (!resampling) return resampling.error();
    const auto job = resampling->bind(cube_of(targets.source), cube_of(targets.cube));
    if (!job) return job.error();
    const auto sky = Sky::create(device);
    if (!sky) return sky.error();
    return sky->bind({targets.panorama.handle(), targets.panorama.view(),
                      targets.panorama.description().width, targets.panorama.description().height});
}

TEST(DriverMemory, MayFailAtEveryCall) {
    auto gpu = value_of(host::Gpu::create());
    const Targets targets{
        cube_to_fill(gpu, 16), cube_to_fill(gpu, 32),
        value_of(gpu.create_image({.width = 8, .height = 4, .usage = VK_IMAGE_USAGE_STORAGE_BIT}))};
    std::size_t k = 0;
    for (bool done = false; !done; ++k) {
        Callbacks callbacks(k);
        Device device = gpu.device();
        device.allocator = callbacks.get();
        {
            const auto made = make_objects(device, targets);
            done = callbacks.calls() <= k;
            EXPECT_EQ(made ? VK_SUCCESS : made.error().code,
                      done ? VK_SUCCESS : VK_ERROR_OUT_OF_HOST_MEMORY)
                << "call " << k;
        }
        EXPECT_EQ(callbacks.live(), 0u) << "call " << k;
    }
    EXPECT_GT(k, 20u); // or nothing took any
    RecordProperty("faults", int(k) - 1);
}

} // namespace
} // namespace lobelia::test
