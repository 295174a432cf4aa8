#pragma once

#include <array>
#include <map>
#include <string>

#include <imgui.h>

namespace lobelia::cli {

/// Where controls are in the window, x y width height in pixels, by the names that scripts know.
using Places = std::map<std::string, std::array<float, 4>>;

/// Controls of the panel that remember where they are.
class Widgets {
public:
    /// Begins a row: its label, in a column of its own. What follows fills the rest.
    void row(const char* label) const;
    void heading(const char* text) const;

    /// A slider that a click with Ctrl sets to `reset`. True when `value` changed.
    bool slider(const char* name, float& value, float least, float most, const char* format,
                float reset);
    /// The same on a scale that is even in log(1 + value), with `format` for the value itself.
    bool log_slider(const char* name, float& value, float most, const char* format, float reset);
    bool button(const char* name, const char* text, float width = 0.0f);
    bool checkbox(const char* name, const char* text, bool& value);
    /// One of `count` texts; true when `chosen` changed.
    bool combo(const char* name, int& chosen, int count, const char* (*text)(void*, int),
               void* texts);
    /// A row of buttons, one of which is chosen.
    bool choice(const char* name, int& chosen, std::initializer_list<const char*> texts);
    /// Remembers the control that was drawn last.
    void mark(const std::string& name);

    const Places& places() const { return places_; }
    void forget() { places_.clear(); }

private:
    Places places_;
};

} // namespace lobelia::cli
