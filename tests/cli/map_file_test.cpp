#include <algorithm>

#include <lobelia/host/write.h>

#include "cli_fixture.h"
#include "support/ktx2_file.h"
#include "support/source.h"

namespace lobelia::test {

namespace {

using namespace std::string_literals;

// VkFormat
constexpr std::uint32_t R16G16B16A16_SFLOAT = 97;
constexpr std::uint32_t R32G32B32A32_SFLOAT = 109;

// As OpenEXR keeps it: name and type, each ending in a zero byte, the length and the text.
std::string attribute(const std::string& name, const std::string& text) {
    return name + "\0string\0"s + char(text.size()) + "\0\0\0"s + text;
}

class MapFile : public CliTest {
protected:
    /// A panorama of radiance 1 + d / 2 towards d: red along x, green along y, blue along z.
    std::string write_slope() const {
        host::Image image{.width = 128, .height = 64};
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 128; ++x) {
                const auto d = oracle::panorama_direction(x + 0.5, y + 0.5, 128, 64);
                for (const double along : {d.x, d.y, d.z})
                    image.texels.push_back(float(1.0 + along / 2.0));
                image.texels.push_back(1.0f);
            }
        const host::Part part{.image = &image};
        EXPECT_TRUE(host::write_exr(folder / "slope.exr", {&part, 1}, host::Content::environment));
        return folder / "slope.exr";
    }
    Ktx2File prefilter(Arguments arguments) const {
        arguments.insert(arguments.begin(), "prefilter");
        arguments.insert(arguments.end(), {"-o", "maps.ktx2"});
        EXPECT_EQ(run_well(arguments), "");
        return Ktx2File(read_bytes(folder / "maps.ktx2"));
    }
};

} // namespace

TEST_F(MapFile, HasTheSharpestLobeInLevelZeroAndTheOthersInOrder) {
    const Ktx2File file =
        prefilter({write_panorama("sky.exr"), "--exponents", "32,512", "--lambert", "--face", "8"});
    EXPECT_EQ(file.format, R16G16B16A16_SFLOAT);
    EXPECT_EQ(file.width, 8u);
    EXPECT_EQ(file.level_count, 3u);
    EXPECT_EQ(file.value_of("lobelia:exponents"), "512,32,1\0"s);
    EXPECT_EQ(file.value_of("lobelia:method"), "chain\0"s);
    EXPECT_EQ(file.value_of("lobelia:quality"), "normal\0"s);
    EXPECT_EQ(file.value_of("lobelia:sampling"), "texel centres\0"s);
    EXPECT_EQ(file.value_of("lobelia:scale"), "1\0"s);
    EXPECT_EQ(file.value_of("lobelia:suns"), "in the texels\0"s);
}

TEST_F(MapFile, KeepsConstantLightConstant) {
    const Ktx2File file = prefilter({write_panorama("sky.exr"), "--exponents", "64,8,0"});
    // Maps and file are stored in 16 bits, to the nearest of 2^-11 each.
    constexpr float TOLERANCE = 2.0f / 2048.0f;
    for (std::uint32_t k = 0; k < file.level_count; ++k)
        for (std::uint32_t face = 0; face < 6; ++face) {
            EXPECT_NEAR(file.channel(k, face, 0, 0, 0), 0.25f, 0.25f * TOLERANCE);
            EXPECT_NEAR(file.channel(k, face, 1, 0, 1), 0.50f, 0.50f * TOLERANCE);
            EXPECT_NEAR(file.channel(k, face, 0, 1, 2), 0.75f, 0.75f * TOLERANCE);
            EXPECT_EQ(file.channel(k, face, 1, 1, 3), 1.0f);
        }
}

TEST_F(MapFile, HasTheFacesAsVulkanReadsThemAndTheLobesByTheClosedForm) {
    const Ktx2File file = prefilter({write_slope(), "--exponents", "256,16,1", "--face", "8"});
    const double exponents[] = {256, 16, 1};
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t face = 0; face < 6; ++face)
            for (std::uint32_t y = 0; y < 8u >> k; ++y)
                for (std::uint32_t x = 0; x < 8u >> k; ++x) {
                    SCOPED_TRACE(testing::Message() << k << ' ' << face << ' ' << x << ' ' << y);
                    const auto d =
                        oracle::cube_direction(int(face), x + 0.5, y + 0.5, int(8u >> k));
                    // Funk-Hecke: a slope keeps its shape and is scaled by (n + 1) / (n + 2).
                    const double scale = (exponents[k] + 1) / (exponents[k] + 2) / 2;
                    const double along[] = {d.x, d.y, d.z};
                    // What the prefilter reaches at any direction is below 5e-3 of the light.
                    for (std::uint32_t c = 0; c < 3; ++c)
                        EXPECT_NEAR(file.channel(k, face, x, y, c), 1 + scale * along[c], 5e-3);
                }
}

TEST_F(MapFile, IsByDefaultWhatEveryLevelsLobeNeeds) {
    const std::string sky = write_panorama("sky.exr");
    // Two texels for each standard deviation 1 / sqrt(n), at least 32 and at most 256.
    EXPECT_EQ(prefilter({sky, "--exponents", "512,128,32"}).width, 128u);
    EXPECT_EQ(prefilter({sky, "--exponents", "16"}).width, 32u);
    EXPECT_EQ(prefilter({sky, "--exponents", "16,15"}).width, 64u);
    EXPECT_EQ(prefilter({sky, "--exponents", "9,8,7,6,5,4,3,2,1"}).levels.size(), 9u);
}

TEST_F(MapFile, Has32BitsWhereASunOverflows16) {
    const std::string sun = LOBELIA_CORPUS_FOLDER "/sun1e9.exr";
    const Ktx2File file = prefilter({sun, "--exponents", "512,1", "--face", "16"});
    EXPECT_EQ(file.format, R32G32B32A32_SFLOAT);
    float brightest = 0.0f;
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t i = 0; i < 256; ++i)
            brightest = std::max(brightest, file.channel(0, face, i % 16, i / 16, 0));
    EXPECT_GT(brightest, 65504.0f);
    EXPECT_LT(brightest, 1e9f);
}

TEST_F(MapFile, IsWhatFormatSaysWhereTheEndingSaysNothing) {
    const std::string sky = write_panorama("sky.exr");
    run_well({"prefilter", sky, "--lambert", "--face", "2", "--format", "ktx2", "-o", "maps.bin"});
    EXPECT_TRUE(read_bytes(folder / "maps.bin").starts_with("\xABKTX 20\xBB"));
    run_well({"prefilter", sky, "--lambert", "--face", "2", "--format", "exr", "-o", "maps.bin"});
    EXPECT_TRUE(read_bytes(folder / "maps.bin").starts_with("\x76\x2f\x31\x01"));
    run_well({"prefilter", sky, "--lambert", "--face", "2", "--format", "ktx2", "-o", "A.KTX2"});
}

TEST_F(MapFile, SaysInOpenExrToo) {
    const std::string sky = write_panorama("sky.exr");
    run_well({"prefilter", sky, "--exponents", "2,8", "--face", "2", "--quality", "high", "-o",
              "maps.exr"});
    const std::string chain = read_bytes(folder / "maps.exr");
    for (const auto& [name, text] : host::Metadata{{"lobelia:exponents", "2,8"},
                                                   {"lobelia:method", "chain"},
                                                   {"lobelia:quality", "high"},
                                                   {"lobelia:sampling", "texel centres"},
                                                   {"lobelia:scale", "1"},
                                                   {"lobelia:suns", "in the texels"}})
        EXPECT_NE(chain.find(attribute(name, text)), std::string::npos) << name;
    run_well({"prefilter", sky, "--lambert", "--face", "2", "--method", "exact", "-o", "maps.exr"});
    const std::string exact = read_bytes(folder / "maps.exr");
    EXPECT_NE(exact.find(attribute("lobelia:method", "exact")), std::string::npos);
    EXPECT_EQ(exact.find("lobelia:quality"), std::string::npos); // it has none
    run_well({"prefilter", sky, "--lambert", "--face", "2", "--method", "importance", "--samples",
              "8", "-o", "maps.exr"});
    const std::string importance = read_bytes(folder / "maps.exr");
    EXPECT_NE(importance.find(attribute("lobelia:samples", "8")), std::string::npos);
}

TEST_F(MapFile, StaysAsItWasWhereThereAreMoreExponentsThanLevels) {
    const std::string sky = write_panorama("sky.exr");
    write_bytes(folder / "maps.ktx2", "old");
    for (const Arguments& arguments : {Arguments{"--exponents", "9,8,7", "--face", "2"},
                                       {"--exponents", "9,8,7,6,5,4,3,2,1,0"}}) {
        Arguments all{"prefilter", sky, "-o", "maps.ktx2"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        expect_refused(run(all), 1, "fewer exponents");
        EXPECT_EQ(read_bytes(folder / "maps.ktx2"), "old");
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"maps.ktx2", "sky.exr"}));
    }
}

} // namespace lobelia::test
