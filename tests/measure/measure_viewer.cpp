// What the viewer costs, driven as by a person on an X server without a screen:
//     measure_viewer [PANORAMA.exr]
// CPU times are the process's, on all its threads, between one frame and the next; medians.

#include <algorithm>
#include <cstdio>
#include <thread>

#include "support/run_program.h"
#include "viewer/session.h"

namespace lobelia::test {
namespace {

using namespace std::chrono_literals;
using Json = ViewerSession::Json;

constexpr int FRAMES = 40;

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

bool draws_the_sphere(const Json& frame) {
    const Json& passes = frame["passes"];
    return std::find(passes.begin(), passes.end(), "sphere") != passes.end();
}

/// CPU time of frames that draw the sphere each time, the light turning, or of frames in which
/// nothing but the mouse moves.
double frame_ms(const Desktop& desktop, const std::vector<std::string>& options, bool turning) {
    TemporaryFolder folder;
    ViewerSession session(desktop, options, folder.path(), {});
    session.window();
    session.wait_until_still();
    session.move_to({900, 400});
    session.wait_until_still();
    session.take_frames();
    std::vector<double> times;
    if (turning) session.key("t");
    for (int i = 0; int(times.size()) < FRAMES; ++i) {
        if (!turning) session.move_to({900 + i % 50, 400});
        const double after = session.last()["frame"].get<double>();
        session.wait_for("a frame",
                         [&](const Json& frame) { return frame["frame"].get<double>() > after; });
        for (const Json& frame : session.take_frames())
            if (draws_the_sphere(frame) == turning && frame["prefilter_passes"] == 0)
                times.push_back(frame["cpu_ms"]);
    }
    session.key("ctrl+q");
    session.child().wait(60s);
    return median(times);
}

void measure_frames(const Desktop& desktop) {
    const std::vector<std::string> whole{"--size", "1280x720", "--method", "two-tap"};
    std::vector<std::string> empty = whole;
    empty.insert(empty.end(), {"--kd", "0", "--ks", "0", "--no-background"});
    const double still = frame_ms(desktop, whole, false), moving = frame_ms(desktop, whole, true);
    const double still_empty = frame_ms(desktop, empty, false),
                 moving_empty = frame_ms(desktop, empty, true);
    std::printf("| CPU of a frame at 1280x720 | two-tap | empty sphere pass | ratio |\n");
    std::printf("| --- | --- | --- | --- |\n");
    std::printf("| still scene | %.1f ms | %.1f ms | %.2f |\n", still, still_empty,
                still / still_empty);
    std::printf("| drawn anew, the light turning | %.1f ms | %.1f ms | %.2f |\n", moving,
                moving_empty, moving / moving_empty);
}

struct Drag {
    double longest_gap = 0.0; // milliseconds by clock
    double cpu_ms = 0.0, most_cpu_ms = 0.0;
    std::size_t frames = 0;
    std::uint64_t prefilter_passes = 0;
};

Drag drag(ViewerSession& session, const std::string& control, float from, float to) {
    session.wait_until_still();
    session.move_to(session.place_of(control, from));
    session.wait_until_still();
    session.take_frames();
    session.press_and_move(session.place_of(control, from), session.place_of(control, to), 60);
    session.wait_until_still();
    Drag result;
    std::vector<double> times;
    double before = -1.0;
    for (const Json& frame : session.take_frames()) {
        const double now = 1e3 * frame["seconds"].get<double>();
        // A second's pause is before or after the drag, not in it.
        if (before >= 0.0 && frame["prefilter_passes"].get<int>() + int(draws_the_sphere(frame)))
            result.longest_gap = std::max(result.longest_gap, now - before);
        before = now;
        ++result.frames;
        result.prefilter_passes += frame["prefilter_passes"].get<std::uint64_t>();
        times.push_back(frame["cpu_ms"]);
    }
    result.cpu_ms = median(times);
    result.most_cpu_ms = *std::max_element(times.begin(), times.end());
    return result;
}

void measure_edits(const Desktop& desktop, const std::string& panorama) {
    TemporaryFolder folder;
    ViewerSession session(desktop, {"--size", "1280x720"}, folder.path(), {});
    const Json first = session.wait_for(
        "the first picture", [](const Json& frame) { return !frame["busy"].get<bool>(); });
    std::printf("\nfirst picture after %.2f s, by clock\n", first["seconds"].get<double>());
    session.window();
    for (const char* const control : {"kd.r", "n"}) {
        const Drag result = drag(session, control, 0.2f, 0.75f);
        std::printf(
            "dragging %s: %zu frames, %llu prefilter passes, %.1f ms CPU a frame and %.1f at "
            "most, longest time between frames %.0f ms\n",
            control, result.frames, static_cast<unsigned long long>(result.prefilter_passes),
            result.cpu_ms, result.most_cpu_ms, result.longest_gap);
    }
    session.click("path");
    session.wait_for("the field", [](const Json& frame) { return frame["typing"] == true; });
    session.type(panorama);
    session.wait_until_still();
    session.take_frames();
    session.key("Return");
    session.wait_for("the panorama",
                     [&](const Json& frame) { return frame["environment"] == panorama; });
    session.wait_until_still();
    double cpu_ms = 0.0, before = -1.0, longest_gap = 0.0;
    for (const Json& frame : session.take_frames()) {
        cpu_ms += frame["cpu_ms"].get<double>();
        const double now = 1e3 * frame["seconds"].get<double>();
        if (before >= 0.0) longest_gap = std::max(longest_gap, now - before);
        before = now;
    }
    std::printf("another panorama, from Enter to the last pass: %.2f s CPU, longest time between "
                "frames %.0f ms\n",
                1e-3 * cpu_ms, longest_gap);
    session.key("ctrl+q");
    session.child().wait(60s);
}

} // namespace
} // namespace lobelia::test

int main(int count, char** arguments) {
    const lobelia::test::Desktop desktop;
    const std::string panorama = count > 1 ? arguments[1] : LOBELIA_PANORAMAS "/city.exr";
    lobelia::test::measure_frames(desktop);
    lobelia::test::measure_edits(desktop, panorama);
}
