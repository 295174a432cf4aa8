#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing.h"
#include "pick.h"
#include "view_state.h"
#include "widgets.h"

namespace lobelia::cli {

/// What the panel tells beside the state.
struct Status {
    std::string device;
    std::string message; // the last one
    bool is_bad = false; // it tells of a failure
    std::string loading; // what is being read; empty: nothing
    double loading_seconds = 0.0;
    double maps_done = 1.0;
    std::optional<double> reference_done;
    double frames_per_second = 0.0;
    double cpu_ms = 0.0;                    // process CPU time of the last frame
    FrameWork work;                         // of the last frame that had any
    std::size_t passes = 0, prefilters = 0; // of the last frame
    std::uint64_t bytes = 0;
    std::optional<Pick> pick;
};

/// What the panel, a key or a dropped file asks for, beyond changes of the state.
struct Requests {
    std::optional<std::string> open; // an environment, empty: the built-in one
    bool save_png = false;
    bool save_exr = false;
    bool copy_command = false;
    bool reset_camera = false;
    bool quit = false;
    std::optional<std::array<std::uint32_t, 2>> pick;
};

/// The controls at the window's left edge.
class Panel {
public:
    /// `start` is what controls go back to.
    explicit Panel(ViewState start) : start_(std::move(start)) {}

    void draw(ViewState& state, const Status& status, Requests& requests);
    /// Environments to choose from are looked for again.
    void list_environments(const std::string& current);
    const Places& places() const { return widgets_.places(); }

private:
    void draw_material(ViewState& state);
    void draw_reflectance(ViewState& state, const char* name, std::array<float, 3>& colour,
                          const std::array<float, 3>& other, const std::array<float, 3>& reset);
    void draw_light(ViewState& state, Requests& requests);
    void draw_method(ViewState& state);
    void draw_output(Requests& requests);
    void draw_status(const Status& status);

    ViewState start_;
    Widgets widgets_;
    bool together_ = false; // the channels of a colour move as one
    std::vector<std::string> environments_;
    char path_[1024] = "";
};

} // namespace lobelia::cli
