#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace lobelia::test {

/// A program that runs beside this one; killed at the end if it still does.
class Child {
public:
    Child(const std::vector<std::string>& command, const std::string& folder,
          const std::vector<std::pair<std::string, std::string>>& environment);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// The next line of its stdout without the newline; nothing at its end or after `timeout`.
    std::optional<std::string> read_line(std::chrono::milliseconds timeout);
    /// Its exit status once it has ended, -1 where a signal ended it; nothing after `timeout`.
    std::optional<int> wait(std::chrono::milliseconds timeout);
    std::string errors() const; // all of its stderr so far
    int process() const { return process_; }

private:
    int process_ = -1;
    int out_ = -1;
    std::string buffer_;
    std::string error_file_;
    std::optional<int> status_;
};

/// An X server without a screen.
class Desktop {
public:
    Desktop();
    const std::string& display() const { return display_; }
    /// Runs a program on it, as in {"xdotool", "key", "s"}, and gives its stdout.
    std::string run(const std::vector<std::string>& command) const;

private:
    Child server_;
    std::string display_;
};

/// `lobelia view` on a desktop, watched by its report of every frame and driven as by a person.
class ViewerSession {
public:
    using Json = nlohmann::json;
    /// `arguments` of the verb; runs in `folder`.
    ViewerSession(const Desktop& desktop, const std::vector<std::string>& arguments,
                  const std::string& folder,
                  std::vector<std::pair<std::string, std::string>> environment);

    /// Reads frames until one is as wanted and gives it; fails the test where none comes in time.
    Json wait_for(const std::string& what, const std::function<bool(const Json&)>& wanted);
    /// Reads frames until nothing has moved for a while, and gives the last one.
    Json wait_until_still();
    const Json& last() const { return last_; }
    /// Frames since the last call.
    std::vector<Json> take_frames() { return std::exchange(frames_, {}); }
    /// Reads what is left once the program has ended.
    void read_rest();
    /// Lines of stdout that are no frame.
    const std::vector<std::string>& strays() const { return strays_; }

    const std::string& window(); // its number, for xdotool
    std::array<int, 2> place_of(const std::string& control, float across = 0.5f) const;
    void move_to(std::array<int, 2> place);
    void press(bool down);
    void press_and_move(std::array<int, 2> from, std::array<int, 2> to, int steps);
    void click(const std::string& control);
    void key(const std::string& keys);
    void type(const std::string& text);
    const Desktop& desktop() const { return desktop_; }

    Child& child() { return child_; }

private:
    std::optional<Json> next_frame(std::chrono::milliseconds timeout);

    const Desktop& desktop_;
    Child child_;
    std::string window_;
    Json last_;
    std::vector<Json> frames_;
    std::vector<std::string> strays_;
};

} // namespace lobelia::test
