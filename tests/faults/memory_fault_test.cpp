#include <functional>

#include <gtest/gtest.h>

#include <lobelia/host/read.h>
#include <lobelia/host/write.h>

#include "library_new.h"
#include "support/gpu_sources.h"
#include "support/run_program.h"
#include "vulkan_shim.h"

// Host memory that runs out, at every single allocation in turn.
namespace lobelia::test {
namespace {

/// Does the work with its k-th allocation failing, for every k. The work says whether it succeeded.
int fail_every_allocation(const std::function<bool()>& work) {
    EXPECT_TRUE(work()); // OpenEXR sets itself up once, and cannot when that was interrupted
    std::size_t k = 0;
    for (bool done = false; !done; ++k) {
        LibraryNew::begin(k);
        bool succeeded = false, thrown = false;
        try {
            succeeded = work();
        } catch (...) {
            thrown = true;
        }
        done = LibraryNew::end() <= k;
        EXPECT_FALSE(thrown) << "allocation " << k << " failed and something was thrown";
        // A message may be lost, the work may not.
        EXPECT_TRUE(succeeded || !done) << "after " << k << " failures";
    }
    return int(k) - 1;
}

class MemoryFaults : public testing::Test {
protected:
    VulkanShim& shim = VulkanShim::get();

    void TearDown() override { EXPECT_EQ(shim.census.alive(), 0u) << shim.census.text(); }
};

TEST_F(MemoryFaults, OfReadingAndWriting) {
    const TemporaryFolder folder;
    const host::Image picture{host::Layout::latlong, 16, 8, 1, std::vector<float>(512, 0.5f)};
    const host::Image cube{host::Layout::cube, 8, 8, 6, std::vector<float>(6 * 64 * 4, 0.5f)};
    const host::Part part{"", &picture};
    int injected = 0;
    const std::string out = folder / "out";
    injected += fail_every_allocation([&] {
        return bool(host::write_exr(out, {&part, 1}, host::Content::picture));
    });
    injected += fail_every_allocation([&] { return bool(host::write_png(out, picture, 0.0f)); });
    injected += fail_every_allocation([&] { return bool(host::write_ktx2(out, {&cube, 1})); });
    for (const char* const file : {"const.exr", "tiled.exr", "multi.exr", "y.exr"})
        injected += fail_every_allocation([path = std::string(LOBELIA_CORPUS_FOLDER "/") + file] {
            return bool(host::read_environment(path));
        });
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
    RecordProperty("faults", injected);
}

TEST_F(MemoryFaults, OfOpeningADevice) {
    RecordProperty("faults", fail_every_allocation([] {
                       return bool(
                           host::Gpu::create({.get_instance_proc_addr = VulkanShim::entry()}));
                   }));
}

} // namespace
} // namespace lobelia::test
