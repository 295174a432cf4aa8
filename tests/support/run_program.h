#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lobelia::test {

/// A program to run and how.
struct ProgramCall {
    std::vector<std::string> command; // path of the program, then its arguments
    std::string folder;               // current directory; empty: the caller's
    std::vector<std::pair<std::string, std::string>> environment; // variables to set
    bool on_terminal = false;                                 // stderr is a terminal, not a pipe
    std::optional<std::chrono::milliseconds> terminate_after; // send SIGTERM then
};

/// What became of it.
struct ProgramResult {
    int status = -1; // exit status, or -1 if a signal ended it
    int signal = 0;  // that signal
    std::string out;
    std::string err;
};

/// Runs the program to its end, with nothing on its stdin.
ProgramResult run_program(const ProgramCall& call);

/// What exec takes: where each text begins, then nothing. Valid as long as the texts are.
std::vector<char*> pointers(std::vector<std::string>& texts);

/// A folder of its own, deleted with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string operator/(const std::string& name) const { return path_ + "/" + name; }
    std::vector<std::string> names() const; // of the files in it, hidden ones too, sorted

private:
    std::string path_;
};

std::string read_bytes(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

} // namespace lobelia::test
