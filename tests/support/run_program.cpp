#include "support/run_program.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lobelia::test {

namespace {

using Clock = std::chrono::steady_clock;

void require(bool succeeded, const char* step) {
    if (!succeeded) throw std::runtime_error(std::string("run_program: ") + step);
}

// Two ends: what the program writes to one comes out of the other.
struct Ends {
    int ours = -1;
    int theirs = -1;
};

Ends make_pipe() {
    int ends[2];
    require(::pipe2(ends, O_CLOEXEC) == 0, "pipe");
    return {ends[0], ends[1]};
}

Ends make_terminal() {
    Ends terminal{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC), -1};
    require(terminal.ours >= 0 && ::grantpt(terminal.ours) == 0 && ::unlockpt(terminal.ours) == 0,
            "terminal");
    terminal.theirs = ::open(::ptsname(terminal.ours), O_RDWR | O_NOCTTY | O_CLOEXEC);
    require(terminal.theirs >= 0, "terminal");
    return terminal;
}

std::vector<std::string> variables(const ProgramCall& call) {
    std::vector<std::string> all;
    for (char** variable = environ; *variable; ++variable) {
        const std::string text = *variable;
        const bool is_replaced =
            std::any_of(call.environment.begin(), call.environment.end(),
                        [&](const auto& entry) { return text.starts_with(entry.first + "="); });
        if (!is_replaced) all.push_back(text);
    }
    for (const auto& [name, value] : call.environment) all.push_back(name + "=" + value);
    return all;
}

pid_t spawn(const ProgramCall& call, const Ends& out, const Ends& err) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, out.theirs, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, err.theirs, STDERR_FILENO);
    if (!call.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, call.folder.c_str());
    std::vector<std::string> command = call.command;
    std::vector<std::string> environment = variables(call);
    pid_t process = 0;
    const int code = ::posix_spawn(&process, command[0].c_str(), &actions, nullptr,
                                   pointers(command).data(), pointers(environment).data());
    ::posix_spawn_file_actions_destroy(&actions);
    require(code == 0, "spawn");
    return process;
}

// Appends what is there; false at the end. A terminal that nobody writes to any more gives an
// error.
bool drain(int end, std::string& text) {
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(end, bytes.data(), bytes.size());
    if (count > 0) text.append(bytes.data(), std::size_t(count));
    return count > 0;
}

int milliseconds_until(Clock::time_point moment) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(moment - Clock::now()).count();
    return int(std::max<long long>(left, 0));
}

// Reads both until the program closes them, terminating it when it is time.
void collect(const ProgramCall& call, pid_t process, std::array<pollfd, 2>& ends,
             std::array<std::string*, 2> texts) {
    const Clock::time_point started = Clock::now();
    bool terminated = !call.terminate_after;
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        const int patience = terminated ? -1 : milliseconds_until(started + *call.terminate_after);
        const int ready = ::poll(ends.data(), ends.size(), patience);
        if (ready == 0 && !terminated) {
            ::kill(process, SIGTERM);
            terminated = true;
        }
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (ends[i].revents && !drain(ends[i].fd, *texts[i])) ends[i].fd = -1;
    }
}

} // namespace

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (std::string& text : texts) all.push_back(text.data());
    all.push_back(nullptr);
    return all;
}

ProgramResult run_program(const ProgramCall& call) {
    const Ends out = make_pipe();
    const Ends err = call.on_terminal ? make_terminal() : make_pipe();
    const pid_t process = spawn(call, out, err);
    ::close(out.theirs);
    ::close(err.theirs);

    ProgramResult result;
    std::array<pollfd, 2> ends{{{out.ours, POLLIN, 0}, {err.ours, POLLIN, 0}}};
    collect(call, process, ends, {&result.out, &result.err});
    ::close(out.ours);
    ::close(err.ours);
    int status = 0;
    require(::waitpid(process, &status, 0) == process, "wait");
    if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    return result;
}

TemporaryFolder::TemporaryFolder() {
    path_ = std::filesystem::temp_directory_path() / "lobelia test XXXXXX"; // a space on purpose
    require(::mkdtemp(path_.data()) != nullptr, "temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

std::string read_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace lobelia::test
