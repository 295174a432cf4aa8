#include "program.h"

#include <cstdio>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" char** environ;

namespace lobelia::cli {

using host::Failure;
using host::Outcome;

namespace {

/// A file without a name, to hand to another program.
class Scratch {
public:
    Scratch() : file_(std::tmpfile()) {}
    ~Scratch() {
        if (file_) std::fclose(file_);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    bool fill(const std::string& text) {
        return file_ && std::fwrite(text.data(), 1, text.size(), file_) == text.size() &&
               std::fflush(file_) == 0 && ::lseek(descriptor(), 0, SEEK_SET) == 0;
    }
    std::string read() {
        std::string text;
        std::rewind(file_);
        char part[65536];
        while (const std::size_t count = std::fread(part, 1, sizeof part, file_))
            text.append(part, count);
        return text;
    }
    explicit operator bool() const { return file_ != nullptr; }
    int descriptor() const { return ::fileno(file_); }

private:
    std::FILE* file_;
};

// Runs a program and waits for it; its exit status, or -1 where it could not be started.
int run(std::vector<std::string> arguments, int in, int out, int err) {
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, err, STDERR_FILENO);
    pid_t process = 0;
    const int failed =
        ::posix_spawnp(&process, words.front(), &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (failed) return -1;
    int status = 0;
    if (::waitpid(process, &status, 0) != process || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

} // namespace

bool has_program(const std::string& name) {
    Scratch in, out;
    return in && out &&
           run({name, "--version"}, in.descriptor(), out.descriptor(), out.descriptor()) == 0;
}

Outcome<std::string> run_program(const std::vector<std::string>& words, const std::string& input) {
    Scratch in, out, err;
    if (!err || !out || !in.fill(input))
        return Failure{"there is no place for temporary files, make room or set TMPDIR"};
    if (run(words, in.descriptor(), out.descriptor(), err.descriptor()) != 0)
        return Failure{words.front() + " failed: " + err.read()};
    return out.read();
}

} // namespace lobelia::cli
