#include "drop_file.h"

#include <stdexcept>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace lobelia::test {

namespace {

// Lindal and others, "Drag-and-Drop Protocol for the X Window System", version 5.
constexpr long VERSION = 5;

class Drag {
public:
    Drag(Display* display, Window target)
        : display_(display), target_(target),
          source_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)) {
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
    }

    void drop(const std::string& uris) {
        const long source = long(source_);
        int x = 0, y = 0;
        Window child = None;
        XWindowAttributes shape{};
        XGetWindowAttributes(display_, target_, &shape);
        XTranslateCoordinates(display_, target_, shape.root, shape.width / 2, shape.height / 2, &x,
                              &y, &child);
        send("XdndEnter", {source, VERSION << 24, long(atom("text/uri-list")), None, None});
        send("XdndPosition",
             {source, 0, long(x) << 16 | y, CurrentTime, long(atom("XdndActionCopy"))});
        wait_for("XdndStatus", uris);
        send("XdndDrop", {source, 0, CurrentTime, 0, 0});
        wait_for("XdndFinished", uris);
    }

private:
    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    void send(const char* type, const long (&values)[5]) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = values[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
    }

    /// Hands the list over whenever the target asks for it.
    void wait_for(const char* type, const std::string& uris) {
        for (XEvent event{};;) {
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) hand_over(event.xselectionrequest, uris);
            if (event.type == ClientMessage && event.xclient.message_type == atom(type)) return;
        }
    }

    void hand_over(const XSelectionRequestEvent& request, const std::string& uris) {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8,
                        PropModeReplace, reinterpret_cast<const unsigned char*>(uris.data()),
                        int(uris.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = request.requestor;
        answer.xselection.selection = request.selection;
        answer.xselection.target = request.target;
        answer.xselection.property = request.property;
        answer.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &answer);
    }

    Display* display_;
    Window target_, source_;
};

} // namespace

void drop_file(const std::string& display, const std::string& window, const std::string& path) {
    Display* const server = XOpenDisplay(display.c_str());
    if (!server) throw std::runtime_error("no X server at " + display);
    Drag(server, std::stoul(window)).drop("file://" + path + "\r\n");
    XCloseDisplay(server);
}

} // namespace lobelia::test
