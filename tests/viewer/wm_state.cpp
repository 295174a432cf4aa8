#include "wm_state.h"

#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace lobelia::test {

// X Consortium, "Inter-Client Communication Conventions Manual", 4.1.3.1: the type of the property
// is WM_STATE too.
void set_minimised(const std::string& display, const std::string& window, bool minimised) {
    Display* const server = XOpenDisplay(display.c_str());
    if (!server) throw std::runtime_error("no X server at " + display);
    const Atom state = XInternAtom(server, "WM_STATE", False);
    const unsigned long values[] = {
        static_cast<unsigned long>(minimised ? IconicState : NormalState), None};
    XChangeProperty(server, std::stoul(window), state, state, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(values), 2);
    XCloseDisplay(server);
}

} // namespace lobelia::test
