#include "failing_new.h"

#include <cstdlib>
#include <new>

#include "vulkan_shim.h"

namespace {

thread_local bool counting = false;
thread_local std::size_t allocations = 0;
thread_local std::size_t failing = 0;

void* allocate(std::size_t size) noexcept {
    if (counting && !lobelia::test::VulkanShim::inside && allocations++ == failing) return nullptr;
    return std::malloc(size ? size : 1);
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
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace lobelia::test {

void FailingNew::begin(std::size_t number) {
    allocations = 0;
    failing = number;
    counting = true;
}

std::size_t FailingNew::end() {
    counting = false;
    return allocations;
}

} // namespace lobelia::test
