#include <cmath>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include <lobelia/host/read.h>

#include "support/gpu_sources.h"
#include "support/run_program.h"

// The engines of tests/examples, built against the installed package: each runs silently under the
// validation layer, and shows what the installed program shows.
namespace lobelia::test {
namespace {

constexpr const char* SYNCHRONISATION =
    "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT";
constexpr const char* ON_THE_GPU = "VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT";

/// Linear R G B from the top, 96 x 96.
struct Picture {
    static constexpr std::size_t SIZE = 96;
    std::vector<float> values;
    float at(std::size_t x, std::size_t y, std::size_t channel) const {
        return values[3 * (y * SIZE + x) + channel];
    }
};

class Engines : public testing::Test {
protected:
    TemporaryFolder folder;

    /// Runs an engine of tests/examples with the layer's `checks`; its picture goes to `name`.
    ProgramResult run(const std::string& engine, std::vector<std::string> arguments,
                      const std::string& checks = SYNCHRONISATION) const {
        arguments.insert(arguments.begin(), LOBELIA_ENGINES "/" + engine);
        return run_program({.command = arguments,
                            .folder = folder.path(),
                            .environment = {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                                            {"VK_LAYER_ENABLES", checks}}});
    }

    void runs_silently(const std::string& engine, const std::vector<std::string>& arguments,
                       const std::string& checks = SYNCHRONISATION) const {
        const ProgramResult result = run(engine, arguments, checks);
        EXPECT_EQ(result.status, 0);
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(result.out.find("VUID"), std::string::npos) << result.out;
        EXPECT_EQ(result.out.find("SYNC-"), std::string::npos) << result.out;
        EXPECT_EQ(result.out.find("UNASSIGNED"), std::string::npos) << result.out;
    }

    Picture read(const std::string& name) const {
        std::istringstream file(read_bytes(folder / name));
        std::string format;
        std::size_t width = 0, height = 0;
        float endian = 0;
        file >> format >> width >> height >> endian;
        EXPECT_EQ(format + (endian < 0 ? " little" : " big"), "PF little");
        EXPECT_EQ(width * height, Picture::SIZE * Picture::SIZE);
        file.get();
        Picture picture{std::vector<float>(3 * Picture::SIZE * Picture::SIZE)};
        for (std::size_t y = Picture::SIZE; y-- > 0;) // from the lowest row up
            file.read(reinterpret_cast<char*>(&picture.values[3 * y * Picture::SIZE]),
                      3 * Picture::SIZE * sizeof(float));
        EXPECT_TRUE(file);
        return picture;
    }

    /// What the installed program shows.
    static const Picture& expected() {
        static const Picture picture = [] {
            const TemporaryFolder own;
            const auto result = run_program({.command = {LOBELIA_INSTALLED_PROGRAM, "render",
                                                         "--size", "96x96", "-o", "sphere.exr"},
                                             .folder = own.path()});
            EXPECT_EQ(result.status, 0) << result.err;
            const auto read = value_of(host::read_environment(own / "sphere.exr"));
            Picture shown;
            for (std::size_t i = 0; i < read.image.texels.size(); ++i)
                if (i % 4 != 3) shown.values.push_back(read.image.texels[i]);
            return shown;
        }();
        return picture;
    }

    void shows_what_the_program_shows(const std::string& engine) const {
        runs_silently(engine, {"picture.pfm"});
        EXPECT_TRUE(read("picture.pfm").values == expected().values);
    }
};

TEST_F(Engines, ShowWhatTheProgramShowsInAMinimalOne) {
    shows_what_the_program_shows("minimal");
}

TEST_F(Engines, ShowWhatTheProgramShowsWithQueuesAndChangingLight) {
    shows_what_the_program_shows("async");
}

TEST_F(Engines, ShowWhatTheProgramShowsByVulkan1_1AndARenderPass) {
    shows_what_the_program_shows("render_pass");
}

TEST_F(Engines, ShowWhatTheProgramShowsFromTwoDevicesAndThreads) {
    shows_what_the_program_shows("two_devices");
}

TEST_F(Engines, ShadeASphereOfTheirOwnAsLobeliaShadesIts) {
    runs_silently("mesh", {"sphere", "picture.pfm"});
    const Picture mesh = read("picture.pfm");
    // Where the sphere covers whole pixels: the mesh's edges are 2 pi / 1024 long, so its position
    // and with it the view are off by 5e-6, and the normals that the triangles interpolate by less;
    // a lobe of n = 64 changes by no more than 8 times an angle. The rest is the sun: P_1000 of it,
    // whose place in the map is as exact as the pixel's direction.
    const double silhouette = std::tan(std::asin(0.25)) / std::tan(std::numbers::pi / 12) * 48;
    for (std::size_t y = 0; y < Picture::SIZE; ++y)
        for (std::size_t x = 0; x < Picture::SIZE; ++x) {
            const double distance = std::hypot(double(x) + 0.5 - 48, double(y) + 0.5 - 48);
            if (std::abs(distance - silhouette) < 1.5) continue;
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_NEAR(mesh.at(x, y, channel), expected().at(x, y, channel),
                            1e-3 * expected().at(x, y, channel))
                    << x << ", " << y;
        }
}

TEST_F(Engines, ShadeAMeshWithANormalMap) {
    runs_silently("mesh", {"knot", "picture.pfm"});
    const Picture knot = read("picture.pfm");
    for (const float value : knot.values) ASSERT_TRUE(std::isfinite(value) && value >= 0);
}

// Looks at bounds only with descriptor indexing, which Mesa 22.3's CPU driver lacks.
TEST_F(Engines, AreSilentUnderGpuAssistedValidation) {
    runs_silently("minimal", {"picture.pfm"}, ON_THE_GPU);
}

TEST_F(Engines, ShowWhatTheProgramShowsInAWindow) {
    const auto display =
        run_program({.command = {"/usr/bin/env", "sh", "-c", "command -v xvfb-run"}});
    if (display.status != 0) GTEST_SKIP() << "there is no xvfb-run";
    const ProgramResult result = run_program(
        {.command = {"/usr/bin/xvfb-run", "-a", LOBELIA_ENGINES "/window", "picture.pfm"},
         .folder = folder.path(),
         .environment = {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                         {"VK_LAYER_ENABLES", SYNCHRONISATION}}});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(read("picture.pfm").values == expected().values);
}

TEST_F(Engines, AreHeardWhereTheyMakeAMistake) {
    for (const char* checks : {SYNCHRONISATION, ON_THE_GPU})
        EXPECT_NE(run("mistake", {"layout"}, checks).out.find("VUID"), std::string::npos) << checks;
    EXPECT_NE(run("mistake", {"hazard"}).out.find("SYNC-HAZARD"), std::string::npos);
}

} // namespace
} // namespace lobelia::test
