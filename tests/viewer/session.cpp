#include "session.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/run_program.h"

namespace lobelia::test {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto PATIENCE = 60s; // with a machine that others use too
constexpr auto STILL = 700ms;

} // namespace

Child::Child(const std::vector<std::string>& command, const std::string& folder,
             const std::vector<std::pair<std::string, std::string>>& environment) {
    std::vector<std::string> words = command;
    const std::vector<char*> arguments = pointers(words);
    char name[] = "/tmp/lobelia-errors-XXXXXX";
    const int errors = mkstemp(name);
    error_file_ = name;
    int ends[2];
    if (errors < 0 || pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(errors, STDERR_FILENO);
        if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
        for (const auto& [variable, value] : environment)
            setenv(variable.c_str(), value.c_str(), 1);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    close(ends[1]);
    close(errors);
    out_ = ends[0];
}

Child::~Child() {
    if (!status_) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    close(out_);
    unlink(error_file_.c_str());
}

std::optional<std::string> Child::read_line(std::chrono::milliseconds timeout) {
    const auto end = Clock::now() + timeout;
    for (;;) {
        if (const auto newline = buffer_.find('\n'); newline != std::string::npos) {
            std::string line = buffer_.substr(0, newline);
            buffer_.erase(0, newline + 1);
            return line;
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
        pollfd ready{out_, POLLIN, 0};
        if (left < 0ms || poll(&ready, 1, int(left.count())) <= 0) return std::nullopt;
        char bytes[65536];
        const ssize_t count = read(out_, bytes, sizeof bytes);
        if (count <= 0) return std::nullopt;
        buffer_.append(bytes, std::size_t(count));
    }
}

std::optional<int> Child::wait(std::chrono::milliseconds timeout) {
    for (const auto end = Clock::now() + timeout; !status_ && Clock::now() < end;) {
        int status = 0;
        if (waitpid(process_, &status, WNOHANG) == process_)
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        else
            std::this_thread::sleep_for(5ms);
    }
    return status_;
}

std::string Child::errors() const {
    return read_bytes(error_file_);
}

Desktop::Desktop()
    : server_({"Xvfb", "-displayfd", "1", "-screen", "0", "1400x900x24", "-nolisten", "tcp"}, "",
              {}) {
    const auto number = server_.read_line(30s);
    if (!number) throw std::runtime_error("Xvfb does not start: " + server_.errors());
    display_ = ":" + *number;
}

std::string Desktop::run(const std::vector<std::string>& command) const {
    std::vector<std::string> words{"/usr/bin/env"}; // finds it
    words.insert(words.end(), command.begin(), command.end());
    const ProgramResult result =
        run_program({.command = words, .folder = "", .environment = {{"DISPLAY", display_}}});
    if (result.status != 0) throw std::runtime_error(command[0] + ": " + result.err);
    return result.out;
}

ViewerSession::ViewerSession(const Desktop& desktop, const std::vector<std::string>& arguments,
                             const std::string& folder,
                             std::vector<std::pair<std::string, std::string>> environment)
    : desktop_(desktop),
      child_(
          [&] {
              std::vector<std::string> command{LOBELIA_PROGRAM, "view", "--json"};
              command.insert(command.end(), arguments.begin(), arguments.end());
              return command;
          }(),
          folder,
          [&] {
              environment.emplace_back("DISPLAY", desktop.display());
              return environment;
          }()) {}

std::optional<ViewerSession::Json> ViewerSession::next_frame(std::chrono::milliseconds timeout) {
    const auto end = Clock::now() + timeout;
    while (Clock::now() < end) {
        const auto line = child_.read_line(
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()) + 1ms);
        if (!line) return std::nullopt;
        Json frame = Json::parse(*line, nullptr, false);
        if (frame.is_object()) {
            last_ = frame;
            frames_.push_back(frame);
            return frame;
        }
        strays_.push_back(*line);
    }
    return std::nullopt;
}

ViewerSession::Json ViewerSession::wait_for(const std::string& what,
                                            const std::function<bool(const Json&)>& wanted) {
    if (!last_.is_null() && wanted(last_)) return last_;
    for (const auto end = Clock::now() + PATIENCE; Clock::now() < end;) {
        const auto frame = next_frame(1s);
        if (frame && wanted(*frame)) return *frame;
        if (child_.wait(0ms)) break;
    }
    throw std::runtime_error("waited in vain for " + what + "; last frame: " + last_.dump() +
                             "; stderr: " + child_.errors());
}

ViewerSession::Json ViewerSession::wait_until_still() {
    wait_for("the first frame", [](const Json&) { return true; });
    for (const auto end = Clock::now() + PATIENCE; Clock::now() < end;)
        if (!next_frame(STILL) && !last_["busy"].get<bool>() && last_["loading"] == "")
            return last_;
    throw std::runtime_error("never still; last frame: " + last_.dump());
}

void ViewerSession::read_rest() {
    while (next_frame(100ms)) {
    }
}

const std::string& ViewerSession::window() {
    if (window_.empty()) {
        window_ = desktop_.run({"xdotool", "search", "--sync", "--onlyvisible", "--pid",
                                std::to_string(child_.process())});
        window_.erase(window_.find('\n'));
        desktop_.run({"xdotool", "windowfocus", "--sync", window_});
    }
    return window_;
}

std::array<int, 2> ViewerSession::place_of(const std::string& control, float across) const {
    const auto place = last_.at("controls").at(control).get<std::array<float, 4>>();
    return {int(place[0] + across * place[2]), int(place[1] + 0.5f * place[3])};
}

// Each step is seen by the program before the next: a person's hand is slower than a frame.
void ViewerSession::move_to(std::array<int, 2> place) {
    desktop_.run({"xdotool", "mousemove", "--window", window(), std::to_string(place[0]),
                  std::to_string(place[1])});
    wait_for("the mouse there", [&](const Json& frame) {
        return frame["mouse"][0] == double(place[0]) && frame["mouse"][1] == double(place[1]);
    });
}

void ViewerSession::press(bool down) {
    desktop_.run({"xdotool", down ? "mousedown" : "mouseup", "1"});
    wait_for("the button", [&](const Json& frame) { return frame["pressed"] == down; });
}

void ViewerSession::press_and_move(std::array<int, 2> from, std::array<int, 2> to, int steps) {
    move_to(from);
    press(true);
    for (int i = 1; i <= steps; ++i)
        move_to({from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps});
    press(false);
}

void ViewerSession::click(const std::string& control) {
    move_to(place_of(control));
    press(true);
    press(false);
}

void ViewerSession::key(const std::string& keys) {
    desktop_.run({"xdotool", "key", keys});
}

void ViewerSession::type(const std::string& text) {
    desktop_.run({"xdotool", "type", "--delay", "15", text});
}

} // namespace lobelia::test
