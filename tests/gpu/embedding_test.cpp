#include "examples/embedding.h"

#include <algorithm>
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

std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(std::string(LOBELIA_SOURCE_FOLDER "/") + path).rdbuf();
    return text.str();
}

/// What stands between the two lines `// [name]` of a file, without what all its lines begin with.
std::string section_of(const std::string& path, const std::string& name) {
    std::vector<std::string> lines;
    std::size_t margin = std::string::npos;
    std::istringstream text(text_of(path));
    bool inside = false;
    for (std::string line; std::getline(text, line);) {
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos && line.substr(begin) == "// [" + name + "]") {
            inside = !inside;
        } else if (inside) {
            margin = std::min(margin, begin);
            lines.push_back(line);
        }
    }
    std::string section;
    for (const std::string& line : lines)
        section += line.substr(std::min(margin, line.size())) + "\n";
    return section;
}

TEST(Readme, ShowsTheSampleThatIsCompiledHere) {
    std::string indented;
    std::istringstream lines(section_of("tests/examples/embedding.h", "sample"));
    for (std::string line; std::getline(lines, line);)
        indented += (line.empty() ? "" : "    " + line) + "\n";
    ASSERT_GT(indented.size(), 1000u);
    EXPECT_NE(text_of("README.md").find(indented), std::string::npos) << indented;
}

TEST(EmbeddingGuide, ShowsWhatTheExamplesCompile) {
    std::istringstream guide(text_of("docs/embedding.md"));
    std::string before, line;
    int listings = 0;
    for (; std::getline(guide, line); before = line) {
        if (!line.starts_with("```") || line == "```") continue;
        // <!-- FILE [SECTION] -->
        std::istringstream origin(before);
        std::string comment, file, section;
        ASSERT_TRUE(origin >> comment >> file >> section && section.size() > 2) << before;
        std::string listing;
        while (std::getline(guide, line) && line != "```") listing += line + "\n";
        EXPECT_EQ(listing, section_of(file, section.substr(1, section.size() - 2)));
        ++listings;
    }
    EXPECT_GE(listings, 7);
}

} // namespace
} // namespace lobelia::test
