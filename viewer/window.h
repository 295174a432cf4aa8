#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <lobelia/host/gpu.h>

struct GLFWwindow;

namespace lobelia::cli {

/// A key that went down, by GLFW's number, and the modifiers that were held then.
struct KeyPress {
    int key = 0;
    int modifiers = 0;
};

/// A window of the system, with what the person did to it since the last look. One at a time, on
/// the program's first thread.
class Window {
public:
    /// Fails where there is no display, with what to do.
    static host::Outcome<Window> create(const std::string& title, VkExtent2D size);

    GLFWwindow* handle() const { return state_->handle.get(); }
    /// For host::GpuOptions; must not outlive the window.
    host::Presentation presentation() const;

    bool asked_to_close() const;
    VkExtent2D size() const; // pixels; 0x0 while minimised
    float scale() const;     // of text, as the monitor asks for

    /// Sleeps until something happens, no longer than `seconds`; below 0: however long it takes.
    void wait(double seconds) const;
    /// Ends wait(). Any thread may.
    static void wake();

    /// Whether the person or the system did anything since the last call.
    bool take_stir() { return std::exchange(state_->stirred, false); }
    /// Files that were dropped onto the window since the last call.
    std::vector<std::string> take_dropped() { return std::exchange(state_->dropped, {}); }
    /// Keys that went down since the last call, also those that are up again.
    std::vector<KeyPress> take_keys() { return std::exchange(state_->keys, {}); }

private:
    struct Destroy {
        void operator()(GLFWwindow* window) const;
    };
    struct State {
        std::unique_ptr<GLFWwindow, Destroy> handle;
        std::vector<std::string> dropped;
        std::vector<KeyPress> keys;
        bool stirred = false;
    };
    static State& state_of(GLFWwindow* window);
    static void watch(GLFWwindow* window);
    explicit Window(std::unique_ptr<State> state) : state_(std::move(state)) {}

    std::unique_ptr<State> state_; // stays where it is: the system's callbacks refer to it
};

} // namespace lobelia::cli
