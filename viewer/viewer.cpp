#include "viewer.h"

#include <algorithm>

#include <GLFW/glfw3.h>

#include "command_line.h"
#include "controls.h"
#include "frame_clock.h"
#include "messages.h"
#include "overlay.h"
#include "renderer.h"
#include "screenshot.h"
#include "shown_environment.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr int FRAMES_AFTER_AN_EVENT = 3; // in which the panel comes to rest
constexpr double FASTEST_FRAME = 1.0 / 60.0;
constexpr double LOADING_FRAME = 0.1; // seconds: the time that is shown goes on

class Viewer {
public:
    Viewer(const ViewerStart& start, Window window)
        : start_(start), state_(start.state), window_(std::move(window)), gui_(window_.handle()),
          panel_(start.state) {}
    Outcome<Done> run();

private:
    void wait();
    Outcome<Done> update_environment();
    Outcome<Done> frame();
    Outcome<Done> draw_gui(Requests& requests);
    Outcome<Done> recover(const host::Failure& failure);
    void answer(const Requests& requests);
    void pick(std::uint32_t x, std::uint32_t y);
    void save(const std::string& ending);
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
    ShownEnvironment environment_; // ends before the window that its loader wakes
    std::string picked_in_;        // the command of the picture that `status_.pick` is about
    bool rebuilt_ = false;
    bool minimised_ = false;
    bool stuck_ = false; // the stage failed; another state may do
    int redraw_ = FRAMES_AFTER_AN_EVENT;
    FrameClock clock_;
};

void Viewer::tell(const std::string& message, bool is_bad) {
    status_.message = message;
    status_.is_bad = is_bad;
}

void Viewer::wait() {
    double seconds = environment_.is_loading() ? LOADING_FRAME : -1.0;
    if (minimised_) {
        seconds = -1.0;
    } else if (!stuck_ && (renderer_->stage().is_busy() || environment_.is_on_its_way() ||
                           state_.turning != 0.0f)) {
        seconds = std::clamp(FASTEST_FRAME - clock_.since_frame(), 0.0, FASTEST_FRAME);
    } else if (redraw_ > 0) {
        seconds = 0.0;
        --redraw_;
    }
    window_.wait(seconds);
    if (!window_.take_stir()) return;
    redraw_ = FRAMES_AFTER_AN_EVENT;
    stuck_ = false;
}

Outcome<Done> Viewer::update_environment() {
    const auto news = environment_.update(*renderer_, state_);
    if (!news) return news.error();
    if (!*news) return Done{};
    tell((*news)->message, (*news)->is_bad);
    if ((*news)->is_bad) return Done{};
    status_.pick.reset();
    panel_.list_environments(state_.environment);
    const std::size_t name = state_.environment.find_last_of('/') + 1;
    glfwSetWindowTitle(window_.handle(),
                       state_.environment.empty()
                           ? "Lobelia"
                           : (state_.environment.substr(name) + " - Lobelia").c_str());
    return Done{};
}

void Viewer::pick(std::uint32_t x, std::uint32_t y) {
    const VkExtent2D extent = renderer_->extent();
    status_.pick.reset();
    if (!renderer_->stage().has_pictures() || x >= extent.width || y >= extent.height) return;
    const auto pick = renderer_->stage().pick(state_, x, y);
    if (!pick) return tell(pick.error().message, true);
    status_.pick = *pick;
    picked_in_ = command_line(state_, extent);
}

void Viewer::save(const std::string& ending) {
    if (!renderer_->stage().has_pictures()) return;
    const auto saved =
        save_screenshot(renderer_->gpu(), renderer_->stage(), state_, renderer_->extent(), ending);
    tell(saved ? "saved " + *saved : saved.error().message, !saved);
}

void Viewer::answer(const Requests& requests) {
    if (requests.open) environment_.open(*requests.open);
    if (requests.reset_camera) state_.settings.view.camera = start_.state.settings.view.camera;
    if (requests.pick) pick((*requests.pick)[0], (*requests.pick)[1]);
    if (requests.save_png) save(".png");
    if (requests.save_exr) save(".exr");
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
    const Loader& loader = environment_.loader();
    status_.loading = environment_.is_loading() ? loader.path() : "";
    status_.loading_seconds = environment_.is_loading() ? loader.seconds() : 0.0;
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
    clock_.tick();
    status_.cpu_ms = clock_.cpu_ms();
    status_.frames_per_second = clock_.frames_per_second();
    ++report_.frame;
    report_.seconds = clock_.seconds();
    report_.size = renderer_->extent();
    report_.environments = environment_.count();
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
    if (stage.environment() && !environment_.has_quality(state_.settings.quality))
        if (const auto shown = environment_.show(*renderer_, state_); !shown) return shown;

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
    environment_.leave_device();
    renderer_.reset();
    auto renderer = Renderer::create(start_.gpu, window_);
    if (!renderer) return renderer.error();
    renderer_ = std::move(*renderer);
    tell("the device was lost and has been started anew", true);
    return environment_.show(*renderer_, state_);
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
    environment_.open(state_.environment);
    while (!window_.asked_to_close()) {
        auto done = update_environment();
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
