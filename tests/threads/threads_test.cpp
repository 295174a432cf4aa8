#include <array>
#include <atomic>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include <lobelia/host/read.h>
#include <lobelia/host/work.h>
#include <lobelia/host/write.h>

#include "support/core_jobs.h"
#include "support/run_program.h"

// What docs/embedding.md allows several threads to do at once. Under ThreadSanitizer
// (`./lobelia test --all`, preset `threads`) a race shows even where all came out right.
namespace lobelia::test {
namespace {

constexpr std::size_t THREADS = 4;

/// Runs `work(i)` on each thread, all of them let go at once.
void at_once(const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> waiting = THREADS;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < THREADS; ++i)
        threads.emplace_back([&, i] {
            for (--waiting; waiting > 0;) std::this_thread::yield();
            work(i);
        });
    for (std::thread& thread : threads) thread.join();
}

TEST(Threads, CreateBindAndRecordOnOneDevice) {
    for (int round = 0; round < 4; ++round)
        at_once([](std::size_t first) {
            const auto jobs = core_jobs(); // each thread begins with another
            for (std::size_t i = 0; i < jobs.size(); ++i) jobs[(first + i) % jobs.size()].make()();
        });
}

TEST(Threads, RecordTheSameJob) {
    for (const CoreJob& job : core_jobs()) {
        const auto record = job.make();
        at_once([&](std::size_t) { record(); });
    }
}

// Opened, worked with and closed on the thread, the first work among it: what is computed once for
// all is computed by whoever comes first.
TEST(Threads, HaveDevicesOfTheirOwn) {
    std::array<std::vector<float>, THREADS> pictures;
    std::atomic<int> failed = 0;
    at_once([&](std::size_t i) {
        auto gpu = host::Gpu::create();
        const auto environment = gpu ? host::make_builtin_environment(*gpu, 32)
                                     : host::Outcome<host::GpuEnvironment>(gpu.error());
        if (!environment) return void(++failed);
        auto rendering = host::render(*gpu, *environment, {.view = {.width = 32, .height = 32}});
        if (!rendering) return void(++failed);
        pictures[i] = std::move(rendering->picture.texels);
    });
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(pictures[0].size(), 4u * 32u * 32u);
    for (const std::vector<float>& picture : pictures) EXPECT_EQ(picture, pictures[0]);
}

TEST(Threads, WriteAndReadFiles) {
    const TemporaryFolder folder;
    std::atomic<int> failed = 0;
    at_once([&](std::size_t i) {
        const host::Image image{host::Layout::latlong, 16, 8, 1, std::vector<float>(512, 1.0f)};
        const host::Part part{"", &image};
        const std::string path = folder / std::to_string(i) + ".exr";
        for (int k = 0; k < 10; ++k) {
            failed += !host::write_exr(path, {&part, 1}, host::Content::environment);
            failed += !host::write_png(path + ".png", image, 0.0f);
            failed += !host::read_environment(path);
        }
    });
    EXPECT_EQ(failed, 0);
}

} // namespace
} // namespace lobelia::test
