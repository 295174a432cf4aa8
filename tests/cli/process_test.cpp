#include <csignal>
#include <filesystem>

#include "cli_fixture.h"

namespace lobelia::test {

namespace {

using Names = std::vector<std::string>;
using namespace std::chrono_literals;

class ProcessTest : public CliTest {
protected:
    // The same call under a limit on the size of files, in blocks of 512 or 1024 bytes.
    ProgramCall limited(const Arguments& arguments) const {
        ProgramCall result = call(arguments);
        result.command.insert(result.command.begin(),
                              {"/bin/sh", "-c", "ulimit -f 1 && exec \"$@\"", "sh"});
        // Counts of coverage are a file, too.
        result.environment.push_back({"LLVM_PROFILE_FILE", "/dev/null"});
        return result;
    }

    // Takes long enough to be seen and interrupted.
    const Arguments LONG_WORK{"render",    "--method", "reference", "--size",
                              "1024x1024", "-o",       "a.exr"};
};

} // namespace

TEST_F(ProcessTest, KeepsTheOldFileWhenTheDiskIsFull) {
    std::filesystem::create_symlink("/dev/full", folder / "full.exr");
    expect_refused(run({"render", "--size", "8x8", "-o", "full.exr"}), 1, "full.exr");
    EXPECT_EQ(folder.names(), Names{"full.exr"});
}

TEST_F(ProcessTest, KeepsTheOldFileBeyondALimitOnFiles) {
    write_bytes(folder / "a.exr", "old");
    const ProgramResult result = run_program(limited({"render", "--size", "64x64", "-o", "a.exr"}));
    expect_refused(result, 1, "a.exr");
    EXPECT_EQ(folder.names(), Names{"a.exr"});
    EXPECT_EQ(read_bytes(folder / "a.exr"), "old");
}

TEST_F(ProcessTest, LeavesNoFileWhenOneOfSeveralFails) {
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    expect_refused(run({"render", "--size", "8x8", "-o", "new.exr", "-o", "full.png"}), 1,
                   "full.png");
    EXPECT_EQ(folder.names(), Names{"full.png"});
}

TEST_F(ProcessTest, FailsWhenStandardOutputIsFull) {
    ProgramCall full = call({"devices"});
    full.command.insert(full.command.begin(), {"/bin/sh", "-c", "exec \"$@\" >/dev/full", "sh"});
    expect_refused(run_program(full), 1, "standard output");
}

TEST_F(ProcessTest, EndsByTheSignalThatItGetsAndLeavesNothing) {
    ProgramCall interrupted = call(LONG_WORK);
    interrupted.terminate_after = 1000ms;
    const ProgramResult result = run_program(interrupted);
    EXPECT_EQ(result.signal, SIGTERM) << "ended by itself with status " << result.status;
    EXPECT_EQ(result.err, ""); // no progress into a pipe
    EXPECT_EQ(folder.names(), Names{});
}

TEST_F(ProcessTest, ShowsProgressOnATerminal) {
    ProgramCall watched = call(LONG_WORK);
    watched.on_terminal = true;
    watched.terminate_after = 3000ms;
    EXPECT_NE(run_program(watched).err.find("lobelia: rendering"), std::string::npos);
}

TEST_F(ProcessTest, DoesNotDependOnTheLocale) {
    if (run_program({.command = {"/bin/sh", "-c", "command -v localedef locale"}}).status != 0)
        GTEST_SKIP() << "localedef is not installed";
    TemporaryFolder locales;
    run_program({.command = {"/bin/sh", "-c", "localedef -i de_DE -f UTF-8 ./de_DE.UTF-8"},
                 .folder = locales.path()});
    ProgramCall german{.command = {"/bin/sh", "-c", "locale decimal_point"},
                       .environment = {{"LOCPATH", locales.path()}, {"LC_ALL", "de_DE.UTF-8"}}};
    if (run_program(german).out != ",\n") GTEST_SKIP() << "there is no German locale to build";

    const Arguments work{"render", "--kd", "0.25", "-n", "1.5", "--size", "8x8", "-o", "a.exr"};
    run_well(work);
    const std::string expected = read_bytes(folder / "a.exr");
    german.command = call(work).command;
    german.folder = folder.path();
    EXPECT_EQ(run_program(german).status, 0);
    EXPECT_TRUE(read_bytes(folder / "a.exr") == expected);
    german.command = call({"render", "-n", "0,5"}).command;
    expect_refused(run_program(german), 2, "0,5");
}

} // namespace lobelia::test
