#include "examples/embedding.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "support/gpu_sources.h"
#include "support/gpu_test.h"

// The README's sample does what the README says, and is what the README shows.
namespace lobelia::test {
namespace {

class EmbeddingTest : public GpuTest {};

TEST_F(EmbeddingTest, LightsASceneFromTheEnginesOwnObjects) {
    constexpr std::uint32_t SIZE = 32;
    host::Image light{host::Layout::cube, SIZE, SIZE, 6,
                      std::vector<float>(24 * SIZE * SIZE, 1.5f)};
    auto sky = value_of(
        gpu.create_image({.width = SIZE,
                          .height = SIZE,
                          .layers = 6,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          .cube = true}));
    value_of(gpu.upload(light, sky));

    std::vector<host::GpuImage> images;
    std::vector<host::GpuBuffer> buffers;
    Engine engine{
        gpu.device().handle, gpu.device().get_device_proc_addr,
        [&](const PrefilteredMap& map) {
            images.push_back(value_of(
                gpu.create_image({.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                  .width = map.size,
                                  .height = map.size,
                                  .layers = 6,
                                  .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                  .cube = true})));
            return CubeMap{images.back().handle(), VK_FORMAT_R16G16B16A16_SFLOAT, map.size, 1};
        },
        [&](VkDeviceSize bytes) {
            buffers.push_back(value_of(gpu.create_buffer(
                bytes,
                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
                host::Memory::host)));
            return buffers.back().handle();
        }};
    const auto job = light_scene(engine, {sky.handle(), VK_FORMAT_R32G32B32A32_SFLOAT, SIZE, 1});
    ASSERT_TRUE(job);
    const std::array exponents = {16.0f, 64.0f, 700.0f};
    const auto plan =
        PrefilterPlan::make({.exponents = exponents, .lambert = true, .source_size = SIZE});
    ASSERT_TRUE(plan);
    value_of(gpu.submit(
        [&](VkCommandBuffer commands) { job->record(commands, 0, plan->pass_count()); }));

    float scale = 0.0f;
    std::memcpy(&scale, buffers.back().data() + 4, sizeof scale);
    for (const host::GpuImage& image : images) {
        const host::Image map =
            value_of(gpu.download(image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
        // Constant light stays as it is, to a half's rounding.
        for (std::size_t i = 0; i < map.texels.size(); i += 4)
            ASSERT_NEAR(map.texels[i] / scale, 1.5f, 1.5f / 2048) << image.description().width;
    }
}

TEST(Readme, ShowsTheSampleThatIsCompiledHere) {
    const auto text_of = [](const std::string& path) {
        std::ostringstream text;
        text << std::ifstream(std::string(LOBELIA_SOURCE_FOLDER "/") + path).rdbuf();
        return text.str();
    };
    const std::string source = text_of("tests/examples/embedding.h");
    const std::string marker = "// [sample]\n";
    const std::size_t begin = source.find(marker) + marker.size();
    const std::string sample = source.substr(begin, source.find(marker, begin) - begin);
    std::string indented;
    std::istringstream lines(sample);
    for (std::string line; std::getline(lines, line);)
        indented += (line.empty() ? "" : "    " + line) + "\n";
    EXPECT_NE(text_of("README.md").find(indented), std::string::npos) << indented;
}

} // namespace
} // namespace lobelia::test
