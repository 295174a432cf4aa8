#include <cmath>

#include "viewer_fixture.h"

// What the panel shows beside the material, reached by the keys that F1 lists.
namespace lobelia::test {

namespace {

/// Mean of a pixel's colour channels.
int grey(const PngFile& image, std::uint32_t x, std::uint32_t y) {
    const auto texel = image.at(x, y);
    return (texel[0] + texel[1] + texel[2]) / 3;
}

} // namespace

TEST_F(ViewerTest, ShowsBackgroundLobesAndErrorsByKeys) {
    // Few pixels, so that a reference is there soon.
    ViewerSession session(desktop, {"--size", "520x300"}, folder.path(), VALIDATED);
    session.window();
    session.wait_until_still();
    session.move_to({510, 20});
    const auto press = [&](const std::string& key) {
        session.key(key);
        session.wait_for("a frame after " + key, [&, n = session.last()["frame"].get<int>()](
                                                     const Json& f) { return f["frame"] > n; });
        session.wait_until_still();
        return seen(session);
    };
    const PngFile both = seen(session);

    // The sphere covers columns 260 +- 145, the panel those up to 308.
    const PngFile diffuse = press("2"), specular = press("3");
    EXPECT_EQ(session.last()["prefilter_passes"], 0);
    EXPECT_GT(largest_difference(both, diffuse, 310, 380), 10);
    EXPECT_GT(largest_difference(both, specular, 310, 380), 10);
    EXPECT_EQ(largest_difference(both, press("1"), 310, 520), 0);

    const PngFile blurred = press("b");
    EXPECT_GT(largest_difference(both, blurred, 430, 520), 10);
    const PngFile off = press("b");
    EXPECT_EQ(grey(off, 515, 40), 0);
    EXPECT_EQ(largest_difference(both, press("b"), 310, 520), 0);

    // One pixel, shown and as it should be.
    session.desktop().run(
        {"xdotool", "mousemove", "--window", session.window(), "330", "150", "click", "3"});
    const Json pick = session.wait_for(
        "a pixel", [](const Json& frame) { return !frame["pick"].is_null(); })["pick"];
    EXPECT_EQ(pick["x"], 330);
    // The ray (slope, 0, -1) from (0, 0, 4) meets the unit sphere after 4 - z.
    const double slope = 2.0 * std::tan(15.0 * M_PI / 180.0) / 300.0 * (330.5 - 260.0);
    const double depth = (4.0 - std::sqrt(1.0 - 15.0 * slope * slope)) / (1.0 + slope * slope);
    EXPECT_NEAR(pick["normal"][0].get<double>(), slope * depth, 1e-3);
    EXPECT_LT(pick["error"].get<float>(), 0.05f);

    session.key("e");
    // Pixels sixteen apart come first, from the top.
    session.wait_for("a reference", [](const Json& frame) {
        return frame["errors"] == true && frame["reference"].is_number() &&
               frame["reference"] > 0.002;
    });
    const PngFile errors = seen(session);
    EXPECT_GT(largest_difference(both, errors, 310, 380), 10);
    session.key("e");
    session.wait_for("no errors", [](const Json& frame) { return frame["errors"] == false; });
    session.wait_until_still();

    expect_good_end(session);
}

TEST_F(ViewerTest, HidesThePanelHelpsAndScalesByKeys) {
    ViewerSession session(desktop, {"--size", "900x760", "--method", "kurt2019"}, folder.path(),
                          VALIDATED);
    session.window();
    session.wait_until_still();
    const float row = session.last()["controls"]["n"][3].get<float>();
    const PngFile first = seen(session);

    session.key("F1");
    session.wait_for("help", [](const Json& frame) { return frame["help"] == true; });
    session.wait_until_still();
    EXPECT_GT(largest_difference(first, seen(session), 400, 500), 50);
    session.key("Escape");
    session.wait_for("no help", [](const Json& frame) { return frame["help"] == false; });

    session.key("Tab");
    session.wait_for("no panel", [](const Json& frame) { return frame["panel"] == false; });
    session.wait_until_still();
    EXPECT_GT(largest_difference(first, seen(session), 0, 200), 20);
    EXPECT_TRUE(session.last()["controls"].empty());
    session.key("Tab");
    session.wait_for("the panel", [](const Json& frame) { return frame["panel"] == true; });

    for (int i = 0; i < 4; ++i) {
        const float before = session.last()["controls"]["n"][3].get<float>();
        session.key("ctrl+equal");
        session.wait_for("larger text", [&](const Json& frame) {
            return frame["controls"]["n"][3].get<float>() > before;
        });
    }
    EXPECT_NEAR(session.last()["controls"]["n"][3].get<float>(), 2.0f * row, 2.0f);
    session.key("ctrl+0");
    session.wait_for("text as it was", [&](const Json& frame) {
        return frame["controls"]["n"][3].get<float>() == row;
    });

    session.key("t");
    session.wait_for("a turn", [](const Json& frame) { return frame["rotation"] > 1.0; });
    session.key("t");
    session.wait_until_still();
    session.key("c");
    session.wait_for("the command", [](const Json& frame) {
        return frame["message"] == "copied: " + frame["command"].get<std::string>();
    });
    EXPECT_NE(session.last()["command"].get<std::string>().find("--rotate"), std::string::npos);
    expect_good_end(session);
}

} // namespace lobelia::test
