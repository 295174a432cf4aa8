#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "drop_file.h"
#include "viewer_fixture.h"
#include "wm_state.h"

namespace lobelia::test {

namespace {

using namespace std::chrono_literals;

std::uint64_t prefilter_passes(const std::vector<Json>& frames) {
    std::uint64_t passes = 0;
    for (const Json& frame : frames) passes += frame["prefilter_passes"].get<std::uint64_t>();
    return passes;
}

std::string only_file(const TemporaryFolder& folder, const std::string& ending) {
    std::string found;
    for (const std::string& name : folder.names())
        if (name.starts_with("lobelia-") && name.ends_with(ending)) {
            EXPECT_EQ(found, "");
            found = name;
        }
    EXPECT_NE(found, "");
    return folder / found;
}

} // namespace

TEST_F(ViewerTest, EditsTheMaterialAndTheEnvironment) {
    ViewerSession session(desktop, {"--size", "900x760"}, folder.path(), VALIDATED);
    session.window();
    session.wait_until_still();
    EXPECT_EQ(session.last()["environments_shown"], 1);
    EXPECT_EQ(session.last()["n"], 64.0);
    const PngFile first = seen(session);
    EXPECT_EQ(first.width, 900u);
    EXPECT_EQ(first.height, 760u);

    // Dragging kd: the sphere alone, and never more than the energy there is.
    session.take_frames();
    session.press_and_move(session.place_of("kd.r", 0.3f), session.place_of("kd.r", 0.99f), 12);
    session.wait_for("kd at its limit", [](const Json& frame) {
        return frame["kd"][0].get<float>() > 0.399f && !frame["busy"].get<bool>();
    });
    session.wait_until_still();
    const auto kd_frames = session.take_frames();
    EXPECT_EQ(prefilter_passes(kd_frames), 0u);
    for (const Json& frame : kd_frames)
        EXPECT_LE(frame["kd"][0].get<double>() + frame["ks"][0].get<double>(), 1.0 + 1e-6);
    session.move_to(session.place_of("kd.r"));
    desktop.run({"xdotool", "keydown", "ctrl"});
    session.click("kd.r");
    desktop.run({"xdotool", "keyup", "ctrl"});
    session.wait_for("kd as it was",
                     [](const Json& frame) { return frame["kd"][0].get<float>() == 0.3f; });

    // Dragging n: frames go on, and maps follow.
    session.wait_until_still();
    session.take_frames();
    session.press_and_move(session.place_of("n", 0.45f), session.place_of("n", 0.7f), 12);
    session.wait_for("a larger n", [](const Json& frame) { return frame["n"] > 300.0; });
    session.wait_until_still();
    EXPECT_GT(prefilter_passes(session.take_frames()), 0u);
    const PngFile sharper = seen(session);
    EXPECT_GT(largest_difference(first, sharper, 400, 900), 10);

    // A file that is none: a message and the old picture. Then one that is.
    const auto type_path = [&](const std::string& path) {
        session.click("path");
        session.wait_for("the field", [](const Json& frame) { return frame["typing"] == true; });
        session.type(path);
        session.key("Return");
    };
    type_path("missing.exr");
    session.wait_for("a message", [](const Json& frame) {
        return frame["message"].get<std::string>().starts_with("missing.exr");
    });
    EXPECT_EQ(session.wait_until_still()["environments_shown"], 1);
    EXPECT_EQ(largest_difference(sharper, seen(session), 400, 900), 0);
    std::filesystem::copy(LOBELIA_CORPUS_FOLDER "/17x9.exr", folder / "other.exr");
    type_path("other.exr");
    session.wait_for("another environment",
                     [](const Json& frame) { return frame["environment"] == "other.exr"; });
    EXPECT_EQ(session.wait_until_still()["environments_shown"], 2);
    drop_file(desktop.display(), session.window(), LOBELIA_CORPUS_FOLDER "/sun1e9.exr");
    session.wait_for("the file that was dropped", [](const Json& frame) {
        return frame["environment"] == LOBELIA_CORPUS_FOLDER "/sun1e9.exr";
    });
    EXPECT_EQ(session.wait_until_still()["environments_shown"], 3);
    EXPECT_GT(largest_difference(sharper, seen(session), 400, 900), 10);

    expect_good_end(session);
}

TEST_F(ViewerTest, ComparesMethodsAndKeepsPictures) {
    ViewerSession session(desktop, {"--size", "900x760"}, folder.path(), VALIDATED);
    session.window();
    session.wait_until_still();

    // Another method, chosen from the list; two side by side.
    const PngFile by_two_tap = seen(session);
    session.click("method");
    session.wait_for("the list of methods", [](const Json& frame) {
        return frame["controls"].contains("method.kurt2019");
    });
    session.click("method.kurt2019");
    session.wait_for("the method", [](const Json& frame) { return frame["method"] == "kurt2019"; });
    session.move_to({700, 20});
    session.wait_until_still();
    const PngFile by_paper = seen(session);
    EXPECT_GT(largest_difference(by_two_tap, by_paper, 400, 900), 3);
    session.click("other");
    session.wait_for("the list of methods",
                     [](const Json& frame) { return frame["controls"].contains("other.two-tap"); });
    session.click("other.two-tap");
    session.wait_for("the split",
                     [](const Json& frame) { return frame["right_method"] == "two-tap"; });
    session.press_and_move({450, 300}, {600, 300}, 5);
    session.wait_for("the line moved", [](const Json& frame) {
        return std::abs(frame["divider"].get<float>() - 600.0f / 900.0f) < 0.01f;
    });
    session.move_to({700, 20});
    session.wait_until_still();
    const PngFile both = seen(session);
    EXPECT_EQ(largest_difference(both, by_paper, 400, 500), 0) << "left of the label";
    EXPECT_EQ(largest_difference(both, by_two_tap, 720, 900), 0) << "right of the label";

    // Pictures of what is seen, and the command for one method.
    session.key("s");
    session.wait_for("one method",
                     [](const Json& frame) { return frame["right_method"].is_null(); });
    session.key("p");
    session.wait_for("a picture", [](const Json& frame) {
        return frame["message"].get<std::string>().ends_with(".png");
    });
    session.key("x");
    session.wait_for("another picture", [](const Json& frame) {
        return frame["message"].get<std::string>().ends_with(".exr");
    });
    const std::string png = only_file(folder, ".png"), exr = only_file(folder, ".exr");
    // The device rounds to bytes, and so does the host.
    EXPECT_LE(largest_difference(read_png(png), by_paper, 400, 900), 1);
    const std::string command = session.last()["command"];
    EXPECT_NE(read_bytes(png).find(command), std::string::npos);
    EXPECT_NE(read_bytes(exr).find(command), std::string::npos);
    const std::string program =
        std::string(LOBELIA_PROGRAM) + command.substr(command.find(' ')) + " -o rendered.png";
    const ProgramResult rendered =
        run_program({.command = {"/bin/sh", "-c", program}, .folder = folder.path()});
    EXPECT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_LE(largest_difference(read_png(folder / "rendered.png"), read_png(png), 0, 900), 1);

    expect_good_end(session);
}

TEST_F(ViewerTest, OutlivesEverySize) {
    ViewerSession session(desktop, {"--size", "500x400", "--method", "kurt2019"}, folder.path(),
                          VALIDATED);
    const std::string window = session.window();
    session.wait_until_still();
    const auto resize = [&](int width, int height) {
        desktop.run(
            {"xdotool", "windowsize", window, std::to_string(width), std::to_string(height)});
    };
    const auto minimise = [&](bool minimised) {
        set_minimised(desktop.display(), window, minimised);
    };
    for (int i = 0; i < 200; ++i) {
        if (i % 50 == 25) { // a size of 0x0 for the program
            minimise(true);
            resize(40 + i, 40);
            minimise(false);
        }
        if (i % 20 == 10)
            resize(1, 1);
        else
            resize(1 + 37 * i % 640, 1 + 53 * i % 480);
    }
    resize(420, 310);
    session.wait_for("the last size", [](const Json& frame) {
        return frame["width"] == 420 && frame["height"] == 310;
    });
    session.wait_until_still();
    const PngFile picture = seen(session);
    EXPECT_EQ(picture.width, 420u);
    EXPECT_EQ(picture.height, 310u);

    minimise(true);
    std::this_thread::sleep_for(500ms);
    session.read_rest();
    session.take_frames();
    session.key("t"); // draws all the time, once there is something to draw on
    std::this_thread::sleep_for(500ms);
    session.read_rest();
    EXPECT_TRUE(session.take_frames().empty());
    minimise(false);
    session.wait_for("frames again", [](const Json& frame) { return frame["rotation"] != 0.0; });
    expect_good_end(session);
}

TEST_F(ViewerTest, ClosesWhileItReads) {
    ViewerSession session(desktop, {LOBELIA_CORPUS_FOLDER "/17x9.exr"}, folder.path(), VALIDATED);
    session.window();
    expect_good_end(session);
}

TEST_F(ViewerTest, StartsALostDeviceAnewOnce) {
    ViewerSession session(
        desktop, {"--size", "500x400"}, folder.path(),
        {{"LD_PRELOAD", LOBELIA_LOSE_DEVICE}, {"LOBELIA_LOSE_DEVICE_FILE", folder / "lose"}});
    session.window();
    session.wait_until_still();
    write_bytes(folder / "lose", "");
    session.key("2");
    session.wait_for("a new device", [](const Json& frame) {
        return frame["message"].get<std::string>().find("started anew") != std::string::npos;
    });
    session.wait_until_still();
    EXPECT_EQ(session.last()["environments_shown"], 2);
    expect_good_end(session);
}

TEST_F(ViewerTest, SaysWhyItCannotStart) {
    const ProgramResult without_display =
        run_program({.command = {LOBELIA_PROGRAM, "view"},
                     .folder = folder.path(),
                     .environment = {{"DISPLAY", ":not-there"}, {"WAYLAND_DISPLAY", ""}}});
    EXPECT_EQ(without_display.status, 1);
    EXPECT_TRUE(without_display.err.starts_with("lobelia: cannot ")) << without_display.err;
    const ProgramResult without_file =
        run_program({.command = {LOBELIA_PROGRAM, "view", "missing.exr"},
                     .folder = folder.path(),
                     .environment = {{"DISPLAY", desktop.display()}}});
    EXPECT_EQ(without_file.status, 1);
    EXPECT_TRUE(without_file.err.starts_with("lobelia: missing.exr: ")) << without_file.err;
    EXPECT_TRUE(folder.names().empty());
}

} // namespace lobelia::test
