#include "live_allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "vulkan_shim.h"

namespace {

thread_local bool counting = false;
std::atomic<std::ptrdiff_t> live = 0;

/// Before each block, as large as the strictest alignment.
struct alignas(std::max_align_t) Header {
    bool counts;
};

void* allocate(std::size_t size) noexcept {
    void* const memory = std::malloc(sizeof(Header) + size);
    if (!memory) return nullptr;
    auto* const header = new (memory) Header{counting && !lobelia::test::VulkanShim::inside};
    if (header->counts) ++live;
    return header + 1;
}

void release(void* memory) noexcept {
    if (!memory) return;
    auto* const header = static_cast<Header*>(memory) - 1;
    if (header->counts) --live;
    std::free(header);
}

} // namespace

void* operator new(std::size_t size) {
    if (void* const memory = allocate(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}

namespace lobelia::test {

void count_allocations() {
    counting = true;
}

std::ptrdiff_t live_allocations() {
    return live;
}

} // namespace lobelia::test
