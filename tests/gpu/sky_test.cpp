#include <lobelia/sky.h>

#include "support/gpu_sources.h"
#include "support/gpu_test.h"

// The built-in environment.
namespace lobelia::test {
namespace {

class SkyTest : public GpuTest {
protected:
    host::Image draw(std::uint32_t width, std::uint32_t height) {
        const host::GpuImage target = value_of(gpu.create_image(
            {.width = width,
             .height = height,
             .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                      VK_IMAGE_USAGE_SAMPLED_BIT}));
        const SkyJob job = value_of(sky_.bind({target.handle(), target.view(), width, height}));
        value_of(gpu.submit([&](VkCommandBuffer commands) { job.record(commands); }));
        return value_of(gpu.download(target, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
    }

private:
    Sky sky_ = value_of(Sky::create(gpu.device()));
};

TEST_F(SkyTest, HasTheSamePowerAtEverySize) {
    const oracle::Rgb mean = source_of(draw(1024, 512)).mean();
    struct Size {
        std::uint32_t width, height;
        double tolerance; // of the light without the sun, which sixteen samples a texel see
    };
    for (const Size& size : {Size{2048, 1024, 1e-3},
                             {512, 256, 1e-3},
                             {333, 200, 1e-2},
                             {128, 64, 1e-2},
                             {64, 32, 2e-2}}) {
        const oracle::Rgb found = source_of(draw(size.width, size.height)).mean();
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c] / mean[c], 1.0, size.tolerance)
                << size.width << " x " << size.height << " channel " << c;
    }
}

TEST_F(SkyTest, HasASunOfAFewTexelsAndNothingNegative) {
    for (const auto& [width, height] : {std::pair{1024u, 512u}, {2u, 1u}, {3u, 70u}}) {
        const host::Image image = draw(width, height);
        float brightest = 0.0f;
        for (const float value : image.texels) {
            ASSERT_TRUE(value >= 0.0f && value < 1e5f) << width << " x " << height;
            brightest = std::max(brightest, value);
        }
        if (width < 1024) continue;
        EXPECT_GT(brightest, 1e4f);
        int texels = 0;
        for (std::size_t i = 0; i < image.texels.size(); i += 4)
            texels += image.texels[i] > 0.01f * brightest;
        EXPECT_GT(texels, 8);
        EXPECT_LT(texels, 64);
    }
}

TEST_F(SkyTest, RefusesATargetThatIsTooSmall) {
    const Sky sky = value_of(Sky::create(gpu.device()));
    const auto job = sky.bind({});
    ASSERT_FALSE(job);
    EXPECT_STREQ(job.error().step, "SkyTarget needs an image and a view of at least 2 x 1 texels");
}

} // namespace
} // namespace lobelia::test
