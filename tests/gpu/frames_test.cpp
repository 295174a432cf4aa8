#include <lobelia/host/frames.h>

#include "furnace.h"

// The sphere in light that changes from frame to frame.
namespace lobelia::test {
namespace {

class FramesTest : public SphereTest {
protected:
    const SphereView view{.material = grey(0.3f, 0.6f, 20.0f), .width = 24, .height = 16};
};

TEST_F(FramesTest, ShowEachFramesOwnLight) {
    const std::array lights{image_of(oracle::random_cube(oracle::Scene::suns, 32, 1)),
                            image_of(oracle::random_cube(oracle::Scene::noise, 32, 2))};
    std::vector<host::Image> shown;
    const host::Frames frames = value_of(host::draw_frames(
        gpu, {.view = view}, 3,
        [&](std::size_t i) {
            return host::FrameLight{lights[i % 2], 0.5f * float(i)};
        },
        [&](std::size_t i, host::Image picture) -> host::Outcome<Done> {
            EXPECT_EQ(i, shown.size());
            shown.push_back(std::move(picture));
            return Done{};
        }));
    EXPECT_GT(frames.still.wall_ms, 0.0);
    EXPECT_GT(frames.changing.cpu_ms, 0.0);
    ASSERT_EQ(shown.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        SphereView alone = view;
        alone.environment_rotation = 0.5f * float(i);
        const host::Image expected = draw(upload(lights[i % 2]), alone, SphereMethod::two_tap);
        // A loop over no suns and no loop are other code: the last bits may differ.
        for (std::size_t k = 0; k < expected.texels.size(); ++k)
            ASSERT_NEAR(shown[i].texels[k], expected.texels[k],
                        1e-5f * std::abs(expected.texels[k]))
                << "frame " << i << " value " << k;
    }
}

TEST_F(FramesTest, StopWhereTheyAreAskedTo) {
    const host::Image light = image_of(oracle::random_cube(oracle::Scene::noise, 16, 2));
    const auto refused = [&](std::size_t count) {
        const auto frames = host::draw_frames(
            gpu, {.view = view}, count, [&](std::size_t) { return host::FrameLight{light}; },
            [](std::size_t, host::Image) -> host::Outcome<Done> {
                return host::Failure{"enough"};
            });
        return frames ? "" : frames.error().message;
    };
    EXPECT_EQ(refused(5), "enough");
    EXPECT_EQ(refused(0), "there are no frames, give at least one");
}

} // namespace
} // namespace lobelia::test
