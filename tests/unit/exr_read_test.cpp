#include <cmath>
#include <limits>

#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <lobelia/host/read.h>

#include "file_fixtures.h"

namespace lobelia::test {

using host::read_environment;

namespace {

constexpr int WIDTH = 20; // two blocks of DWA and more than one tile, both incomplete
constexpr int HEIGHT = 10;

Imf::Header make_header(Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    Imf::Header header(WIDTH, HEIGHT);
    header.compression() = compression;
    return header;
}

std::vector<float> expected_colour() {
    std::vector<float> colour;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x)
            for (const Channel& channel : colour_channels())
                colour.push_back(float(channel.value(x, y)));
    return colour;
}

bool is_lossless(Imf::Compression compression) {
    return compression <= Imf::PIZ_COMPRESSION;
}

} // namespace

class ExrReadTest : public FileTest {
protected:
    std::string make(const Imf::Header& header, const std::vector<Channel>& channels) const {
        make_exr(path("a.exr"), header, channels);
        return path("a.exr");
    }
    void expect_colour(const Imf::Header& header, const std::vector<float>& expected) const {
        const auto environment = read_environment(make(header, colour_channels()));
        ASSERT_TRUE(environment) << environment.error().message;
        EXPECT_EQ(colour_of(environment->image), expected);
    }
};

TEST_F(ExrReadTest, ReadsEveryCompressionOfEveryTypeAsOpenExrDoes) {
    std::vector<std::vector<Channel>> kinds;
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT})
        kinds.push_back(colour_channels(type));
    kinds.push_back(colour_channels(Imf::HALF));
    kinds.back()[1].type = Imf::FLOAT;
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const std::vector<Channel>& channels : kinds)
            for (const bool tiled : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << "compression " << compression << " types " << channels[0].type
                             << channels[1].type << " tiled " << tiled);
                Imf::Header header = make_header(Imf::Compression(compression));
                if (tiled) header.setTileDescription(Imf::TileDescription(16, 8));
                const std::string file = make(header, channels);
                const auto environment = read_environment(file);
                ASSERT_TRUE(environment) << environment.error().message;
                std::vector<float> truth = read_by_openexr(file);
                for (float& value : truth) value = std::max(value, 0.0f); // lossy ones undershoot
                EXPECT_EQ(colour_of(environment->image), truth);
                if (is_lossless(Imf::Compression(compression)) && channels[1].type != Imf::UINT) {
                    EXPECT_EQ(truth, expected_colour());
                }
            }
}

TEST_F(ExrReadTest, ReadsChannelsOfMixedTypesAndIgnoresTheOthers) {
    std::vector<Channel> channels = colour_channels();
    channels[0].type = Imf::UINT;
    channels[2].type = Imf::HALF;
    for (const char* other : {"A", "Z", "diffuse.R"})
        channels.push_back({other, Imf::HALF, [](int, int) { return std::nan(""); }});
    const auto environment = read_environment(make(make_header(), channels));
    ASSERT_TRUE(environment) << environment.error().message;
    EXPECT_EQ(colour_of(environment->image), expected_colour());
    EXPECT_EQ(environment->sanitised.not_a_number, 0u);
    EXPECT_EQ(environment->image.texels[3], 1.0f);
}

TEST_F(ExrReadTest, ReadsTheFullSizeLevelOfMipmapsAndRipmaps) {
    for (const Imf::LevelMode mode : {Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
        Imf::Header header = make_header();
        header.setTileDescription(Imf::TileDescription(8, 4, mode));
        expect_colour(header, expected_colour());
    }
}

TEST_F(ExrReadTest, ReadsEveryLineOrder) {
    Imf::Header header = make_header(Imf::ZIPS_COMPRESSION);
    header.lineOrder() = Imf::DECREASING_Y;
    expect_colour(header, expected_colour());
    header.setTileDescription(Imf::TileDescription(8, 4));
    expect_colour(header, expected_colour());
    header.lineOrder() = Imf::RANDOM_Y;
    expect_colour(header, expected_colour());
}

TEST_F(ExrReadTest, PutsTheDataWindowIntoTheDisplayWindow) {
    Imf::Header header = make_header();
    header.displayWindow() = {{-2, -1}, {WIDTH - 5, HEIGHT}}; // more at two sides, less at another
    const auto environment = read_environment(make(header, colour_channels()));
    ASSERT_TRUE(environment) << environment.error().message;
    const host::Image& image = environment->image;
    ASSERT_EQ(image.width, unsigned(WIDTH - 2));
    ASSERT_EQ(image.height, unsigned(HEIGHT + 2));
    for (int y = -1; y <= HEIGHT; ++y)
        for (int x = -2; x < WIDTH - 4; ++x) {
            const bool inside = x >= 0 && y >= 0 && y < HEIGHT;
            EXPECT_EQ(*image.texel(0, unsigned(x + 2), unsigned(y + 1)),
                      inside ? float(x + 32 * y) : 0.0f)
                << x << ", " << y;
        }
}

TEST_F(ExrReadTest, TakesTheDataWindowOfAStatedEnvironmentMap) {
    Imf::Header header = make_header();
    Imf::addEnvmap(header, Imf::ENVMAP_LATLONG);
    header.displayWindow() = {{0, 0}, {99, 99}};
    expect_colour(header, expected_colour());
}

TEST_F(ExrReadTest, ReadsWindowsFarFromTheOrigin) {
    for (const int corner : {-1'000'000'000, 1'000'000'000}) {
        Imf::Header header = make_header();
        header.dataWindow() =
            header.displayWindow() = {{corner, corner}, {corner + WIDTH - 1, corner + HEIGHT - 1}};
        expect_colour(header, expected_colour());
    }
}

TEST_F(ExrReadTest, TakesLuminanceOrRedAloneAsGrey) {
    for (const char* name : {"Y", "R"}) {
        const auto environment = read_environment(
            make(Imf::Header(2, 1), {{name, Imf::HALF, [](int x, int) { return 1.0 + x; }}}));
        ASSERT_TRUE(environment) << environment.error().message;
        EXPECT_EQ(environment->image.texels, (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 1}));
        EXPECT_EQ(environment->notices.size(), name[0] == 'R' ? 1u : 0u);
    }
}

TEST_F(ExrReadTest, NamesTheChannelsOfAFileWithoutColour) {
    const auto zero = [](int, int) { return 0.0; };
    const auto environment =
        read_environment(make(make_header(), {{"R", Imf::HALF, zero}, {"G", Imf::HALF, zero}}));
    ASSERT_FALSE(environment);
    EXPECT_NE(environment.error().message.find("a.exr: "), std::string::npos);
    EXPECT_NE(environment.error().message.find("G R"), std::string::npos)
        << environment.error().message;
}

TEST_F(ExrReadTest, SanitisesByTheStatedRulesAndCounts) {
    constexpr float INF = std::numeric_limits<float>::infinity();
    constexpr float NAN_ = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> red{NAN_, INF, -INF, -1.0f, 7.0f, 2.0f};
    const auto environment = read_environment(make(
        Imf::Header(6, 1), {{"R", Imf::FLOAT, [&](int x, int) { return red[std::size_t(x)]; }},
                            {"G", Imf::FLOAT, [](int, int) { return 3.0; }},
                            {"B", Imf::FLOAT, [](int x, int) { return x == 0 ? -1.0 : 1e-42; }}}));
    ASSERT_TRUE(environment) << environment.error().message;
    const std::vector<float> expected{0, 7, 0, 0, 7, 2};
    for (unsigned x = 0; x < 6; ++x) {
        EXPECT_EQ(environment->image.texel(0, x, 0)[0], expected[x]) << x;
        EXPECT_EQ(environment->image.texel(0, x, 0)[1], 3.0f);
        EXPECT_EQ(environment->image.texel(0, x, 0)[2], x == 0 ? 0.0f : 1e-42f);
    }
    EXPECT_EQ(environment->sanitised.not_a_number, 1u);
    EXPECT_EQ(environment->sanitised.infinite, 2u);
    EXPECT_EQ(environment->sanitised.negative, 1u);
}

TEST_F(ExrReadTest, RefusesAMapWithoutAFiniteTexel) {
    std::vector<Channel> channels = colour_channels();
    channels[1].value = [](int, int) { return std::nan(""); };
    const auto environment = read_environment(make(make_header(), channels));
    ASSERT_FALSE(environment);
    EXPECT_NE(environment.error().message.find("no finite texel"), std::string::npos);
}

TEST_F(ExrReadTest, NotesWhatIsOddAndKeepsTheValues) {
    Imf::Header header = make_header();
    EXPECT_TRUE(read_environment(make(header, colour_channels()))->notices.empty());
    Imf::addChromaticities(header, Imf::Chromaticities({0.713f, 0.293f}, {0.165f, 0.83f},
                                                       {0.128f, 0.044f}, {0.32168f, 0.33767f}));
    expect_colour(header, expected_colour());
    EXPECT_EQ(read_environment(path("a.exr"))->notices.size(), 1u);
    header.displayWindow().max.x += 4;
    EXPECT_EQ(read_environment(make(header, colour_channels()))->notices.size(), 2u);
}

TEST_F(ExrReadTest, RefusesACubeMapOfTheWrongShape) {
    Imf::Header header = make_header();
    Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
    EXPECT_FALSE(read_environment(make(header, colour_channels())));
}

} // namespace lobelia::test
