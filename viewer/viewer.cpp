#include "viewer.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <GLFW/glfw3.h>

#include "command_line.h"
#include "controls.h"
#include "loader.h"
#include "messages.h"
#include "overlay.h"
#include "renderer.h"
#include "screenshot.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr int FRAMES_AFTER_AN_EVENT = 3; // in which the panel comes to rest
constexpr double FASTEST_FRAME = 1.0 / 60.0;
constexpr double LOADING_FRAME = 0.1; // seconds: the time that is shown goes on

using Clock = std::chrono::steady_clock;

double process_ms() {
    return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

double seconds_since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
}

class Viewer {
public:
    Viewer(const ViewerStart& start, Window window)
        : start_(start), state_(start.state), window_(std::move(window)), gui_(window_.handle()),
          panel_(start.state) {}
    Outcome<Done> run();

private:
    void wait();
    void open(const std::string& path);
    Outcome<Done> take_environment();
    Outcome<Done> show_environment();
    Outcome<Done> frame();
    Outcome<Done> draw_gui(Requests& requests);
    Outcome<Done> recover(const host::Failure& failure);
    void answer(const Requests& requests);
    void pick(std::uint32_t x, std::uint32_t y);
    void save(bool as_exr);
    void tell(const std::string& message, bool is_bad = false);
    void count_frame();

    ViewerStart start_;
    ViewState state_;
    Window window_;
    Gui gui_;
    std::unique_ptr<Renderer> renderer_;
    Panel panel_;
    Controls controls_;
    Status status_;
    FrameReport report_;
    Loader loader_;                           // ends before the window that it wakes
    std::optional<host::Environment> source_; // what is shown; none: the built-in one
    std::optional<std::string> coming_;       // path of what is being read
    bool for_high_quality_ = false;           // the environment's cube map is
    std::string picked_in_; // the command of the picture that `status_.pick` is about
    bool rebuilt_ = false;
    bool minimised_ = false;
    bool stuck_ = false; // the stage failed; another state may do
    int redraw_ = FRAMES_AFTER_AN_EVENT;
    double cpu_ms_ = process_ms();
    Clock::time_point began_ = Clock::now(), last_frame_ = Clock::now();
};

void Viewer::tell(const std::string& message, bool is_bad) {
    status_.message = message;
    status_.is_bad = is_bad;
}

void Viewer::wait() {
    double seconds = loader_.is_busy() ? LOADING_FRAME : -1.0;
    if (minimised_) {
        seconds = -1.0;
    } else if (!stuck_ && (renderer_->stage().is_busy() || state_.turning != 0.0f)) {
        seconds = std::clamp(FASTEST_FRAME - seconds_since(last_frame_), 0.0, FASTEST_FRAME);
    } else if (redraw_ > 0) {
        seconds = 0.0;
        --redraw_;
    }
    window_.wait(seconds);
    if (!window_.take_stir()) return;
    redraw_ = FRAMES_AFTER_AN_EVENT;
    stuck_ = false;
}

void Viewer::open(const std::string& path) {
    if (path.empty()) {
        source_.reset();
        state_.environment.clear();
        if (const auto shown = show_environment(); !shown) tell(shown.error().message, true);
        return;
    }
    coming_ = path;
    loader_.begin(path);
}

// Where the first environment cannot be had there is nothing to show, which is a failure.
Outcome<Done> Viewer::take_environment() {
    auto result = loader_.take();
    if (!result) return Done{};
    const std::string path = *std::exchange(coming_, std::nullopt);
    if (!*result) {
        if (!renderer_->stage().environment()) return result->error();
        tell(result->error().message, true);
        return Done{};
    }
    auto before = std::exchange(source_, std::move(**result));
    const std::string path_before = std::exchange(state_.environment, path);
    if (const auto shown = show_environment(); !shown) {
        if (!renderer_->stage().environment() || renderer_->is_lost()) return shown;
        source_ = std::move(before);
        state_.environment = path_before;
        tell(path + ": " + shown.error().message, true);
        return Done{};
    }
    panel_.list_environments(path);
    const host::Sanitised& replaced = source_->sanitised;
    const std::uint64_t count = replaced.not_a_number + replaced.infinite + replaced.negative;
    tell(count ? std::to_string(count) + " texels were no radiance and are replaced" : "");
    return Done{};
}

Outcome<Done> Viewer::show_environment() {
    host::Gpu& gpu = renderer_->gpu();
    const Quality quality = state_.settings.quality;
    auto environment = source_ ? host::upload_environment(gpu, source_->image, state_.face, quality)
                               : host::make_builtin_environment(gpu, state_.face, quality);
    if (!environment) return environment.error();
    if (const auto set = renderer_->stage().set_environment(std::move(*environment)); !set)
        return set;
    for_high_quality_ = quality == Quality::high;
    ++report_.environments;
    status_.pick.reset();
    const std::size_t name = state_.environment.find_last_of('/') + 1;
    glfwSetWindowTitle(window_.handle(),
                       state_.environment.empty()
                           ? "Lobelia"
                           : (state_.environment.substr(name) + " - Lobelia").c_str());
    return Done{};
}

void Viewer::pick(std::uint32_t x, std::uint32_t y) {
    status_.pick.reset();
    const VkExtent2D extent = renderer_->extent();
    if (!renderer_->stage().has_pictures() || x >= extent.width || y >= extent.height) return;
    const SphereView view = shown_view(state_, extent);
    const auto directions = surface_at(view, x, y);
    if (!directions) return;
    const auto probe = renderer_->stage().probe(state_, x, y);
    if (!probe) return tell(probe.error().message, true);
    status_.pick = {x, y, *directions, view.material.exponent, probe->shown, probe->exact};
    picked_in_ = command_line(state_, extent);
}

void Viewer::save(bool as_exr) {
    Stage& stage = renderer_->stage();
    if (!stage.has_pictures()) return;
    const VkExtent2D extent = renderer_->extent();
    const auto image = as_exr ? seen_radiance(stage, state_)
                              : seen_colours(renderer_->gpu(), stage, state_, extent);
    if (!image) return tell(image.error().message, true);
    const std::string path = new_file_name(as_exr ? ".exr" : ".png");
    const host::Metadata metadata = metadata_of(state_, extent);
    const host::Part part{.image = &*image};
    const auto written = as_exr
                             ? host::write_exr(path, {&part, 1}, host::Content::picture, metadata)
                             : host::write_display_png(path, *image, metadata);
    tell(written ? "saved " + path : written.error().message, !written);
}

void Viewer::answer(const Requests& requests) {
    if (requests.open) open(*requests.open);
    if (requests.reset_camera) state_.settings.view.camera = start_.state.settings.view.camera;
    if (requests.pick) pick((*requests.pick)[0], (*requests.pick)[1]);
    if (requests.save_png) save(false);
    if (requests.save_exr) save(true);
    if (requests.copy_command) {
        const std::string command = command_line(state_, renderer_->extent());
        glfwSetClipboardString(window_.handle(), command.c_str());
        tell("copied: " + command);
    }
    if (requests.quit) glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
}

Outcome<Done> Viewer::draw_gui(Requests& requests) {
    const float scale = window_.scale() * state_.zoom;
    if (scale != gui_.scale()) {
        gui_.set_scale(scale);
        if (const auto loaded = renderer_->reload_fonts(); !loaded) return loaded;
    }
    status_.loading = loader_.is_busy() ? loader_.path() : "";
    status_.loading_seconds = loader_.is_busy() ? loader_.seconds() : 0.0;
    status_.maps_done = renderer_->stage().maps_done();
    status_.reference_done = renderer_->stage().reference_done();
    status_.bytes = renderer_->stage().bytes();
    if (gui_.begin_frame(window_.take_keys())) state_.panel = !state_.panel;
    panel_.draw(state_, status_, requests);
    controls_.apply(state_, requests);
    draw_overlay(state_, status_);
    gui_.end_frame();
    return Done{};
}

void Viewer::count_frame() {
    const double seconds = seconds_since(last_frame_);
    last_frame_ = Clock::now();
    const double cpu = process_ms();
    status_.cpu_ms = cpu - cpu_ms_;
    cpu_ms_ = cpu;
    const double rate = 1.0 / std::max(seconds, 1e-6);
    const double weight = seconds > 0.5 ? 1.0 : 0.1; // it stood still
    status_.frames_per_second += weight * (rate - status_.frames_per_second);
    ++report_.frame;
    report_.seconds = seconds_since(began_);
    report_.size = renderer_->extent();
    report_.busy = renderer_->stage().is_busy();
    if (start_.json) {
        print(as_json_line(report_, state_, status_, panel_.places()));
        std::fflush(stdout);
    }
}

Outcome<Done> Viewer::frame() {
    Stage& stage = renderer_->stage();
    const auto fits = renderer_->fit(window_.size());
    if (!fits) return fits.error();
    minimised_ = !*fits;
    if (minimised_) return Done{};
    if (const auto finished = renderer_->finish(); !finished) return finished;
    Requests requests;
    if (const auto drawn = draw_gui(requests); !drawn) return drawn;
    for (const std::string& path : window_.take_dropped()) requests.open = path;
    answer(requests);
    if (status_.pick && picked_in_ != command_line(state_, renderer_->extent()))
        status_.pick.reset();
    if (stage.environment() && for_high_quality_ != (state_.settings.quality == Quality::high))
        if (const auto shown = show_environment(); !shown) return shown;

    status_.passes = report_.work.size();
    status_.prefilters = prefilter_passes(report_.work);
    report_.work.clear();
    if (!stuck_) {
        if (const auto done = stage.update(state_, renderer_->extent(), report_.work); !done)
            return done;
        if (!report_.work.empty()) {
            status_.work = report_.work;
            redraw_ = std::max(redraw_, 2); // the panel tells of it, then of nothing
        }
    }
    if (const auto shown = renderer_->show(state_); !shown) return shown;
    count_frame();
    return Done{};
}

// A lost device is started anew, once; after other failures the window goes on with the old
// picture.
Outcome<Done> Viewer::recover(const host::Failure& failure) {
    if (!renderer_->is_lost()) {
        if (stuck_) return failure;
        tell(failure.message, true);
        stuck_ = true;
        return Done{};
    }
    if (std::exchange(rebuilt_, true)) return failure;
    renderer_.reset();
    auto renderer = Renderer::create(start_.gpu, window_);
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    tell("the device was lost and has been started anew", true);
    return show_environment();
}

Outcome<Done> Viewer::run() {
    gui_.set_scale(window_.scale() * state_.zoom);
    auto renderer = Renderer::create(start_.gpu, window_);
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    status_.device = renderer_->gpu().description().name;
    if (const auto refused =
            host::check_view(shown_view(state_, start_.size), renderer_->gpu().limits()))
        return *refused;
    panel_.list_environments(state_.environment);
    if (state_.environment.empty()) {
        if (const auto shown = show_environment(); !shown) return shown;
    } else {
        open(state_.environment);
    }
    while (!window_.asked_to_close()) {
        auto done = take_environment();
        if (!done && !renderer_->stage().environment()) return done;
        if (done) done = frame();
        if (!done)
            if (const auto recovered = recover(done.error()); !recovered) return recovered;
        wait();
    }
    return Done{};
}

} // namespace

Outcome<Done> run_viewer(const ViewerStart& start) {
    auto window = Window::create("Lobelia", start.size);
    if (!window) return window.error();
    return Viewer(start, std::move(*window)).run();
}

} // namespace lobelia::cli
