#include "window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

namespace lobelia::cli {

using host::Outcome;

namespace {

host::Failure window_failure(const std::string& step) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return {"cannot " + step + (reason ? " (" + std::string(reason) + ")" : "") +
            "; a desktop is needed (on a machine without one: xvfb-run lobelia view), "
            "`lobelia render` works without"};
}

} // namespace

void Window::Destroy::operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
    glfwTerminate();
}

Outcome<Window> Window::create(const std::string& title, VkExtent2D size) {
    if (!glfwInit()) return window_failure("open a window");
    if (!glfwVulkanSupported()) {
        const host::Failure failure = window_failure("show Vulkan's pictures in a window");
        glfwTerminate();
        return failure;
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    GLFWwindow* const handle =
        glfwCreateWindow(int(size.width), int(size.height), title.c_str(), nullptr, nullptr);
    if (!handle) {
        const host::Failure failure = window_failure("open a window");
        glfwTerminate();
        return failure;
    }
    auto state = std::make_unique<State>();
    state->handle.reset(handle);
    glfwSetWindowUserPointer(handle, state.get());
    watch(handle);
    return Window(std::move(state));
}

Window::State& Window::state_of(GLFWwindow* window) {
    State& state = *static_cast<State*>(glfwGetWindowUserPointer(window));
    state.stirred = true;
    return state;
}

// Gui's callbacks call these too, which were there before them.
void Window::watch(GLFWwindow* window) {
    glfwSetDropCallback(window, [](GLFWwindow* at, int count, const char** paths) {
        auto& dropped = state_of(at).dropped;
        dropped.insert(dropped.end(), paths, paths + count);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* at, int key, int, int action, int modifiers) {
        State& state = state_of(at);
        if (action == GLFW_PRESS && key >= 0) state.keys.push_back({key, modifiers});
    });
    glfwSetCharCallback(window, [](GLFWwindow* at, unsigned) { state_of(at); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* at, int, int, int) { state_of(at); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* at, double, double) { state_of(at); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* at, int) { state_of(at); });
    glfwSetScrollCallback(window, [](GLFWwindow* at, double, double) { state_of(at); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* at, int) { state_of(at); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* at) { state_of(at); });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow* at, int) { state_of(at); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* at, int, int) { state_of(at); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* at, float, float) { state_of(at); });
}

host::Presentation Window::presentation() const {
    std::uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    GLFWwindow* const window = handle();
    return {{names, names + count}, [window](VkInstance instance, VkSurfaceKHR* surface) {
                return glfwCreateWindowSurface(instance, window, nullptr, surface);
            }};
}

bool Window::asked_to_close() const {
    return glfwWindowShouldClose(handle());
}

VkExtent2D Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(handle(), &width, &height);
    if (glfwGetWindowAttrib(handle(), GLFW_ICONIFIED)) return {0, 0};
    return {std::uint32_t(width), std::uint32_t(height)};
}

float Window::scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle(), &x, &y);
    return y;
}

void Window::wait(double seconds) const {
    if (seconds < 0.0)
        glfwWaitEvents();
    else if (seconds == 0.0)
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(seconds);
}

void Window::wake() {
    glfwPostEmptyEvent();
}

} // namespace lobelia::cli
