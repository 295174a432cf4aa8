#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "support/core_jobs.h"
#include "support/fake_device.h"

namespace {

std::uint64_t allocations = 0; // of this program, by operator new

} // namespace

// Not inlined: the compiler would see malloc() meet delete.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size ? size : 1);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (void* const memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

// create() and bind() allocate; record() does not, and what they made they destroy, with the
// device's allocator.
namespace lobelia::test {
namespace {

class Allocation : public testing::TestWithParam<CoreJob> {};

TEST_P(Allocation, IsNoneWhileRecordingAndEverythingIsGivenBack) {
    const std::uint64_t made = FakeDevice::made, destroyed = FakeDevice::destroyed;
    {
        const std::uint64_t before_making = allocations;
        const auto record = GetParam().make();
        EXPECT_GT(allocations, before_making); // the count counts
        EXPECT_EQ(FakeDevice::made > made, GetParam().has_objects);
        const std::uint64_t commands = FakeDevice::commands, before = allocations;
        record();
        EXPECT_EQ(allocations, before);
        EXPECT_GT(FakeDevice::commands, commands);
    }
    EXPECT_EQ(FakeDevice::destroyed - destroyed, FakeDevice::made - made);
    EXPECT_EQ(FakeDevice::strangers, 0u);
}

INSTANTIATE_TEST_SUITE_P(EveryPass, Allocation,
                         testing::ValuesIn(core_jobs().begin(), core_jobs().end()),
                         [](const auto& name) { return name.param.name; });

} // namespace
} // namespace lobelia::test
