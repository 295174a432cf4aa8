#include "library_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "vulkan_shim.h"

namespace {

thread_local bool counting = false;
thread_local std::size_t allocations = 0;
thread_local std::size_t failing = 0;
std::atomic<std::ptrdiff_t> live = 0;

/// Before each block, as large as the strictest alignment.
struct alignas(std::max_align_t) Header {
    bool counts;
};

void* allocate(std::size_t size) noexcept {
    const bool counts = counting && !lobelia::test::VulkanShim::inside;
    if (counts && allocations++ == failing) return nullptr;
    void* const memory = std::malloc(sizeof(Header) + size);
    if (!memory) return nullptr;
    if (counts) ++live;
    return new (memory) Header{counts} + 1;
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

void LibraryNew::begin(std::size_t number) {
    allocations = 0;
    failing = number;
    counting = true;
}

std::size_t LibraryNew::end() {
    counting = false;
    return allocations;
}

std::ptrdiff_t LibraryNew::live() {
    return ::live;
}

} // namespace lobelia::test
