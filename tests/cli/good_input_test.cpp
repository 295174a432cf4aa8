#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include <lobelia/host/read.h>
#include <lobelia/host/write.h>

#include "cli_fixture.h"
#include "support/png_file.h"

namespace lobelia::test {

namespace {

using Names = std::vector<std::string>;
using Json = nlohmann::ordered_json;

constexpr const char* PNG_MAGIC = "\x89PNG\r\n\x1a\n";

Names keys_of(const Json& object) {
    Names keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

host::Image read(const std::string& path) {
    auto environment = host::read_environment(path);
    EXPECT_TRUE(environment) << environment.error().message;
    return environment ? std::move(environment->image) : host::Image{};
}

// As OpenEXR keeps it: name and type, each ending in a zero byte, the length and the text.
std::string name_attribute(const std::string& text) {
    using namespace std::string_literals;
    return "name\0string\0"s + char(text.size()) + "\0\0\0"s + text;
}

class RenderVerb : public CliTest {
protected:
    // The picture's bytes, rendered with these options beside a small size.
    std::string picture(const Arguments& options) const {
        Arguments arguments{"render", "--size", "16x16", "-o", "picture.exr"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        run_well(arguments);
        return read_bytes(folder / "picture.exr");
    }
};

class PrefilterVerb : public CliTest {};
class DevicesVerb : public CliTest {};

} // namespace

TEST_F(RenderVerb, WritesTheFilesItIsGivenAndNoOther) {
    EXPECT_EQ(run_well({"render", "--size", "24x16", "-o", "a.exr", "-o", "b.PNG"}), "");
    EXPECT_EQ(folder.names(), (Names{"a.exr", "b.PNG"}));
    const host::Image image = read(folder / "a.exr");
    EXPECT_EQ(image.width, 24u);
    EXPECT_EQ(image.height, 16u);
    EXPECT_TRUE(read_bytes(folder / "b.PNG").starts_with(PNG_MAGIC));
}

TEST_F(RenderVerb, WritesSphereFilesIntoTheCurrentFolderByDefault) {
    run_well({"render", "--size", "16x16"});
    EXPECT_EQ(folder.names(), (Names{"sphere.exr", "sphere.png"}));
}

TEST_F(RenderVerb, ReplacesAFileThatIsThere) {
    write_bytes(folder / "a.exr", "old");
    run_well({"render", "--size", "16x16", "-o", "a.exr"});
    EXPECT_EQ(folder.names(), Names{"a.exr"});
    EXPECT_EQ(read(folder / "a.exr").width, 16u);
}

TEST_F(RenderVerb, WritesTheSameBytesAgain) {
    EXPECT_TRUE(picture({}) == picture({}));
}

TEST_F(RenderVerb, TakesValuesThatBeginWithAMinusSign) {
    const std::string separate = picture({"--eye", "-4,0,-1"});
    EXPECT_TRUE(separate == picture({"--eye=-4,0,-1"}));
    EXPECT_FALSE(separate == picture({"--eye", "4,0,-1"}));
}

TEST_F(RenderVerb, TakesOneNumberForAGreyColour) {
    EXPECT_TRUE(picture({"--kd", ".25"}) == picture({"--kd", "0.25,0.25,2.5e-1"}));
}

TEST_F(RenderVerb, TakesNoSpecularWhereOnlyDiffuseIsGivenAndTheOtherWayRound) {
    EXPECT_TRUE(picture({"--kd", "1"}) == picture({"--kd", "1", "--ks", "0"}));
    EXPECT_TRUE(picture({"--ks", "1"}) == picture({"--ks", "1", "--kd", "0"}));
}

TEST_F(RenderVerb, HasTheContractsDefaults) {
    EXPECT_TRUE(picture({}) == picture({"--kd", "0.3", "--ks", "0.6", "-n", "64", "--eye", "0,0,4",
                                        "--target", "0,0,0", "--up", "0,1,0", "--fov", "30",
                                        "--rotate", "0", "--method", "two-tap"}));
}

TEST_F(RenderVerb, TurnsTheEnvironmentByWholeTurnsToWhereItWas) {
    EXPECT_TRUE(picture({}) == picture({"--rotate", "-720"}));
    EXPECT_FALSE(picture({}) == picture({"--rotate", "90"}));
}

TEST_F(RenderVerb, BlursTheBackgroundWhereAskedTo) {
    EXPECT_FALSE(picture({"--blur", "20"}) == picture({}));
    EXPECT_FALSE(picture({"--blur", "20"}) == picture({"--blur", "30"}));
    EXPECT_TRUE(picture({"--blur", "20"}) == picture({"--blur", "20"}));
}

TEST_F(RenderVerb, AllowsEnergyGainWithOneWarning) {
    const ProgramResult result = run({"render", "--size", "8x8", "-o", "a.exr", "--kd", "0.8",
                                      "--ks", "0.7", "--allow-energy-gain"});
    expect_refused(result, 0, "warning");
    EXPECT_EQ(folder.names(), Names{"a.exr"});
}

TEST_F(RenderVerb, ShowsTheColourOfAConstantEnvironmentInItsBackground) {
    const std::string panorama = write_panorama("sky.exr");
    run_well({"render", panorama, "--size", "8x8", "--method", "reference", "--ks", "0", "--kd",
              "1", "-o", "a.exr"});
    const host::Image image = read(folder / "a.exr");
    ASSERT_EQ(image.texels.size(), 8u * 8u * 4u);
    // A white diffuse sphere in constant light looks like its background, in the corner and in the
    // middle alike.
    for (const float* texel : {image.texel(0, 0, 0), image.texel(0, 4, 4)}) {
        EXPECT_NEAR(texel[0], 0.25f, 1e-5f);
        EXPECT_NEAR(texel[1], 0.50f, 1e-5f);
        EXPECT_NEAR(texel[2], 0.75f, 1e-5f);
    }
}

TEST_F(RenderVerb, IsOpaqueInPngWhereThereIsABackground) {
    const std::string panorama = write_panorama("sky.exr");
    run_well({"render", panorama, "--size", "8x8", "-o", "with.png"});
    run_well({"render", panorama, "--size", "8x8", "-o", "without.png", "--no-background"});
    const auto corner = [this](const char* name) { return read_png(folder / name).pixels.front(); };
    EXPECT_EQ(corner("with.png")[3], 255);
    EXPECT_EQ(corner("without.png")[3], 0);
    // 0.25, 0.5 and 0.75 keep their order, and the background is not black.
    const auto [red, green, blue, alpha] = corner("with.png");
    EXPECT_GT(red, 64);
    EXPECT_LT(red, green);
    EXPECT_LT(green, blue);
}

TEST_F(RenderVerb, PrintsOneJsonObjectWithTheContractsKeys) {
    const Json report =
        Json::parse(run_well({"render", "--size", "16x16", "-o", "a.exr", "--json"}));
    EXPECT_EQ(keys_of(report), (Names{"device", "driver", "method", "quality", "passes", "images",
                                      "suns", "sanitised", "expected_error", "seconds"}));
    EXPECT_EQ(report["method"], "two-tap");
    EXPECT_EQ(report["sanitised"], nullptr); // no file was read
    EXPECT_GT(report["seconds"], 0.0);
    ASSERT_FALSE(report["passes"].empty());
    for (const Json& pass : report["passes"])
        EXPECT_EQ(keys_of(pass), (Names{"name", "invocations", "bytes_read", "bytes_written",
                                        "cpu_ms", "gpu_ms"}));
    ASSERT_FALSE(report["images"].empty());
    for (const Json& image : report["images"])
        EXPECT_EQ(keys_of(image), (Names{"name", "width", "height", "layers", "levels", "format",
                                         "bytes", "lifetime"}));
}

TEST_F(RenderVerb, CountsTheTexelsThatItReplaced) {
    host::Image image{.width = 4, .height = 2, .texels = std::vector<float>(4 * 2 * 4, 1.0f)};
    image.texel(0, 1, 1)[0] = -1.0f;
    image.texel(0, 2, 1)[1] = std::nanf("");
    const host::Part part{.image = &image};
    ASSERT_TRUE(host::write_exr(folder / "odd.exr", {&part, 1}, host::Content::environment));
    const ProgramResult result =
        run({"render", "odd.exr", "--size", "8x8", "-o", "a.exr", "--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("odd.exr: 1 texel was not a number"), std::string::npos);
    EXPECT_NE(result.err.find("odd.exr: 1 texel was negative"), std::string::npos);
    EXPECT_EQ(Json::parse(result.out)["sanitised"],
              (Json{{"not_a_number", 1}, {"infinite", 0}, {"negative", 1}}));
}

TEST_F(PrefilterVerb, WritesACubeMap) {
    const std::string panorama = write_panorama("sky.exr");
    for (const char* method : {"exact", "chain", "importance", "filtered-importance"}) {
        SCOPED_TRACE(method);
        run_well({"prefilter", panorama, "--exponents", "16", "--face", "4", "--method", method,
                  "-o", "map.exr"});
        const host::Image map = read(folder / "map.exr");
        EXPECT_EQ(map.layout, host::Layout::cube);
        EXPECT_EQ(map.width, 4u);
        EXPECT_EQ(map.layers, 6u);
        // A constant environment stays that constant; these are halves, too, as the chain stores.
        for (std::size_t i = 0; i < map.texels.size(); i += 4) {
            EXPECT_NEAR(map.texels[i], 0.25f, 0.25f * 1e-5f);
            EXPECT_NEAR(map.texels[i + 2], 0.75f, 0.75f * 1e-5f);
        }
    }
}

TEST_F(PrefilterVerb, RefusesANumberOfSamplesBeyondItsRange) {
    const std::string panorama = write_panorama("sky.exr");
    for (const char* samples : {"0", "65536"})
        expect_refused(run({"prefilter", panorama, "--lambert", "--method", "importance",
                            "--samples", samples, "-o", "a.exr"}),
                       1, "65535");
}

TEST_F(PrefilterVerb, WritesACubeMapThatRenderTakesAsItIs) {
    const std::string panorama = write_panorama("sky.exr");
    run_well({"prefilter", panorama, "--lambert", "--face", "4", "-o", "map.exr"});
    run_well({"render", "map.exr", "--size", "8x8", "-o", "a.exr"});
    expect_refused(run({"render", "map.exr", "--face", "8", "-o", "b.exr"}), 1, "--face");
}

TEST_F(PrefilterVerb, WritesAPanoramaOfTheSizeAskedFor) {
    const std::string panorama = write_panorama("sky.exr");
    run_well({"prefilter", panorama, "--method", "exact", "--lambert", "--layout", "latlong",
              "--size", "12x6", "-o", "map.exr"});
    const host::Image map = read(folder / "map.exr");
    EXPECT_EQ(map.layout, host::Layout::latlong);
    EXPECT_EQ(map.width, 12u);
    EXPECT_EQ(map.height, 6u);
}

TEST_F(PrefilterVerb, NamesThePartsOfSeveralExponentsByThem) {
    const std::string panorama = write_panorama("sky.exr");
    run_well({"prefilter", panorama, "--lambert", "--exponents", "0.5,64,1e3", "--face", "2", "-o",
              "map.exr"});
    const std::string bytes = read_bytes(folder / "map.exr");
    for (const char* exponent : {"1", "0.5", "64", "1000"})
        EXPECT_NE(bytes.find(name_attribute(std::string("n=") + exponent)), std::string::npos)
            << exponent;
    EXPECT_NE(bytes.find("1,0.5,64,1000"), std::string::npos);
}

TEST_F(PrefilterVerb, PrintsOneJsonObject) {
    const std::string panorama = write_panorama("sky.exr");
    const Json report = Json::parse(
        run_well({"prefilter", panorama, "--lambert", "--face", "2", "-o", "map.exr", "--json"}));
    EXPECT_EQ(report["method"], "chain");
    EXPECT_EQ(report["quality"], "normal");
    EXPECT_EQ(report["suns"], 0);
    EXPECT_EQ(report["sanitised"]["not_a_number"], 0);
    EXPECT_FALSE(report["passes"].empty());
}

TEST_F(DevicesVerb, ListsWhatThereIsAndWhatIsPicked) {
    const std::string text = run_well({"devices"});
    EXPECT_TRUE(text.starts_with("0  ")) << text;
    EXPECT_NE(text.find("picked: 0, "), std::string::npos) << text;

    const Json all = Json::parse(run_well({"devices", "--json"}));
    ASSERT_FALSE(all["devices"].empty());
    EXPECT_EQ(keys_of(all["devices"][0]), (Names{"index", "name", "driver", "type", "vulkan"}));
    EXPECT_EQ(all["picked"], 0);
}

TEST_F(DevicesVerb, ListsWhatThereIsAlsoWhereTheOneAskedForIsNot) {
    const ProgramResult result = run({"devices", "--device", "abacus", "--json"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("abacus"), std::string::npos);
    const Json all = Json::parse(result.out);
    EXPECT_FALSE(all["devices"].empty());
    EXPECT_EQ(all["picked"], nullptr);
}

} // namespace lobelia::test
