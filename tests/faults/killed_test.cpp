#include <atomic>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <lobelia/host/write.h>

#include "support/run_program.h"

// A process killed at any moment while it writes a file.
namespace lobelia::test {
namespace {

constexpr int KILLS = 200;
constexpr int WRITES = 1000; // of each of several threads

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

[[noreturn]] void write_for_ever(const std::string& path, const std::string& a,
                                 const std::string& b) {
    for (bool first = true;; first = !first)
        if (!host::replace_file(path, bytes_of(first ? a : b))) ::_exit(1);
}

TEST(Killed, LeavesTheOldFileOrTheNewOneAndWhatTheNextWriteSweeps) {
    const TemporaryFolder folder;
    const std::string path = folder / "file";
    const std::string a(1 << 18, 'a'), b(1 << 17, 'b'), c = "c";
    std::minstd_rand random(7);
    int leftovers = 0;
    for (int i = 0; i < KILLS; ++i) {
        ASSERT_TRUE(host::replace_file(path, bytes_of(c)));
        ASSERT_EQ(folder.names(), std::vector<std::string>{"file"}) << "not swept";
        const pid_t child = ::fork();
        if (child == 0) write_for_ever(path, a, b);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 3000));
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the writer failed";
        const std::string found = read_bytes(path);
        ASSERT_TRUE(found == a || found == b || found == c) << found.size() << " bytes";
        leftovers += folder.names().size() > 1;
    }
    EXPECT_GT(leftovers, 0); // else nothing was swept
    RecordProperty("kills", KILLS);
}

TEST(Killed, SweepsNothingThatIsBeingWritten) {
    const TemporaryFolder folder;
    const std::string text(16, 'x');
    std::vector<std::thread> writers;
    std::atomic<int> failed = 0;
    for (int i = 0; i < 4; ++i)
        writers.emplace_back([&, path = folder / std::to_string(i)] {
            for (int k = 0; k < WRITES; ++k) failed += !host::replace_file(path, bytes_of(text));
        });
    for (std::thread& writer : writers) writer.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(folder.names().size(), 4u);
}

TEST(Killed, SweepsOnlyItsOwnKind) {
    const TemporaryFolder folder;
    for (const char* const name : {".lobelia-1-2.tmp", ".lobelia-notes.tmp", ".lobelia-1-2.txt"})
        write_bytes(folder / name, "x");
    ASSERT_TRUE(host::replace_file(folder / "file", bytes_of("x")));
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{".lobelia-1-2.txt", ".lobelia-notes.tmp", "file"}));
}

} // namespace
} // namespace lobelia::test
