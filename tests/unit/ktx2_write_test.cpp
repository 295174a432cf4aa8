#include <limits>
#include <stdexcept>

#include <lobelia/host/write.h>

#include "file_fixtures.h"
#include "support/ktx2_file.h"

namespace lobelia::test {

using host::Image;
using host::Layout;

namespace {

using namespace std::string_literals;

// VkFormat
constexpr std::uint32_t R16G16B16A16_SFLOAT = 97;
constexpr std::uint32_t R32G32B32A32_SFLOAT = 109;

// A whole number that tells every channel of a level's texels from the others and that a half has.
float pattern(std::size_t level, std::size_t index) {
    return float(1 + 1000 * level + index);
}

Image make_level(std::uint32_t size, std::size_t level = 0) {
    Image image{Layout::cube, size, size, 6, {}};
    for (std::size_t i = 0; i < std::size_t(size) * size * 6 * 4; ++i)
        image.texels.push_back(i % 4 == 3 ? 0.5f : pattern(level, i));
    return image;
}

Image grey(float value, std::uint32_t size = 1) {
    return {Layout::cube, size, size, 6, std::vector<float>(std::size_t(size) * size * 24, value)};
}

} // namespace

class Ktx2WriteTest : public FileTest {
protected:
    Ktx2File write_levels(const std::vector<Image>& levels,
                          const host::Metadata& metadata = {}) const {
        const auto written = host::write_ktx2(path("a.ktx2"), levels, metadata);
        if (!written) throw std::runtime_error(written.error().message);
        return Ktx2File(bytes_of(path("a.ktx2")));
    }
    void expect_refused(const std::vector<Image>& levels, const std::string& words,
                        const host::Metadata& metadata = {}) const {
        const auto written = host::write_ktx2(path("a.ktx2"), levels, metadata);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().message.find(path("a.ktx2") + ": "), 0u);
        EXPECT_NE(written.error().message.find(words), std::string::npos)
            << written.error().message;
        EXPECT_EQ(files(), 0u);
    }
};

TEST_F(Ktx2WriteTest, TheHeaderDescribesACubeMap) {
    const Ktx2File file = write_levels({make_level(5), make_level(2), make_level(1)});
    EXPECT_EQ(file.identifier, "\xABKTX 20\xBB\r\n\x1A\n"s);
    EXPECT_EQ(file.format, R16G16B16A16_SFLOAT);
    EXPECT_EQ(file.type_size, 2u);
    EXPECT_EQ(file.width, 5u);
    EXPECT_EQ(file.height, 5u);
    EXPECT_EQ(file.depth, 0u);
    EXPECT_EQ(file.layers, 0u);
    EXPECT_EQ(file.faces, 6u);
    EXPECT_EQ(file.level_count, 3u);
    EXPECT_EQ(file.compression, 0u);
    EXPECT_EQ(file.global_offset, 0u);
    EXPECT_EQ(file.global_size, 0u);
}

TEST_F(Ktx2WriteTest, TheSectionsFollowOneAnotherAndTheSmallestLevelComesFirst) {
    for (const float brightest : {1.0f, 1e9f}) {
        const Ktx2File file =
            write_levels({grey(brightest, 6), grey(1.0f, 3), grey(1.0f, 1)}, {{"a key", "odd"}});
        EXPECT_EQ(file.descriptor_offset, 80u + 3 * 24);
        EXPECT_EQ(file.keys_offset, file.descriptor_offset + file.descriptor_size);
        EXPECT_EQ(file.keys_offset % 4, 0u);
        std::uint64_t end = file.keys_offset + file.keys_size;
        for (const int k : {2, 1, 0}) {
            const Ktx2File::Level& level = file.levels[std::size_t(k)];
            const std::uint64_t edge = 6u >> k, texel = 4 * file.type_size;
            EXPECT_EQ(level.offset % texel, 0u); // the least common multiple with 4
            EXPECT_GE(level.offset, end);
            EXPECT_LT(level.offset, end + texel);
            EXPECT_EQ(level.size, 6 * edge * edge * texel);
            EXPECT_EQ(level.uncompressed_size, level.size);
            end = level.offset + level.size;
        }
        EXPECT_EQ(file.size(), end);
        EXPECT_EQ(file.padding, std::string(file.padding.size(), '\0'));
    }
}

TEST_F(Ktx2WriteTest, TheDescriptorSaysFourSignedFloatsOfLinearRec709) {
    for (const float brightest : {1.0f, 1e9f}) {
        const Ktx2File file = write_levels({grey(brightest)});
        const std::uint32_t bits = 8 * file.type_size;
        std::vector<std::uint32_t> words = {
            92,            // bytes in all: this word, 24 of the block, 16 for each channel
            0,             // Khronos, basic block
            2 | 88 << 16,  // version, bytes of the block
            0x00'01'01'01, // straight alpha; linear; Rec. 709; RGBSDA
            0,             // one texel a block
            4 * bits / 8,  // bytes of plane 0
            0};            // of planes 4 to 7
        for (const std::uint32_t channel : {0u, 1u, 2u, 15u}) {
            const std::uint32_t place = channel == 15 ? 3 : channel;
            words.push_back(place * bits | (bits - 1) << 16 | (0xC0 | channel) << 24);
            words.push_back(0);
            words.push_back(0xBF800000); // -1
            words.push_back(0x3F800000); // 1
        }
        EXPECT_EQ(file.descriptor, words);
    }
}

TEST_F(Ktx2WriteTest, TheKeysAreSortedTextsThatEndInZero) {
    const Ktx2File file =
        write_levels({grey(1)}, {{"lobelia:scale", "1"}, {"\xC3\xA4", ""}, {"Ab", "\xE2\x98\x80"}});
    ASSERT_EQ(file.keys.size(), 6u);
    EXPECT_EQ(file.keys[0], std::pair("Ab"s, "\xE2\x98\x80\0"s));
    EXPECT_EQ(file.keys[1], std::pair("KTXorientation"s, "rd\0"s));
    EXPECT_EQ(file.keys[2].first, "KTXwriter");
    EXPECT_TRUE(file.keys[2].second.starts_with("lobelia ")) << file.keys[2].second;
    EXPECT_TRUE(file.keys[2].second.ends_with('\0'));
    EXPECT_EQ(file.keys[3], std::pair("lobelia:sampling"s, "texel centres\0"s));
    EXPECT_EQ(file.keys[4], std::pair("lobelia:scale"s, "1\0"s));
    EXPECT_EQ(file.keys[5], std::pair("\xC3\xA4"s, "\0"s));
}

TEST_F(Ktx2WriteTest, TheTexelsComeBackInTheirOrderWithAlphaOne) {
    const std::vector<Image> levels = {make_level(4, 0), make_level(2, 1), make_level(1, 2)};
    const Ktx2File file = write_levels(levels);
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t face = 0; face < 6; ++face)
            for (std::uint32_t y = 0; y < levels[k].height; ++y)
                for (std::uint32_t x = 0; x < levels[k].width; ++x) {
                    SCOPED_TRACE(testing::Message() << k << ' ' << face << ' ' << x << ' ' << y);
                    for (std::uint32_t c = 0; c < 3; ++c)
                        EXPECT_EQ(file.channel(k, face, x, y, c), levels[k].texel(face, x, y)[c]);
                    EXPECT_EQ(file.channel(k, face, x, y, 3), 1.0f);
                }
}

TEST_F(Ktx2WriteTest, TheHalvesAreTheNearest) {
    Image image = grey(1.0f);
    image.texels[0] = 2049.0f; // halfway to 2050: to the even one
    image.texels[1] = 2051.0f; // halfway to 2052
    image.texels[2] = 2049.5f;
    const Ktx2File file = write_levels({image});
    EXPECT_EQ(file.channel(0, 0, 0, 0, 0), 2048.0f);
    EXPECT_EQ(file.channel(0, 0, 0, 0, 1), 2052.0f);
    EXPECT_EQ(file.channel(0, 0, 0, 0, 2), 2050.0f);
}

TEST_F(Ktx2WriteTest, TheTexelsHave32BitsWhere16CannotHoldThem) {
    constexpr float LEAST = 0x1p-14f; // that a half holds with all its bits
    constexpr float INF = std::numeric_limits<float>::infinity();
    for (const float value : {0.0f, LEAST, 65504.0f, -65504.0f}) {
        const Ktx2File file = write_levels({grey(value)});
        EXPECT_EQ(file.format, R16G16B16A16_SFLOAT) << value;
        EXPECT_EQ(file.channel(0, 5, 0, 0, 2), value);
    }
    for (const float value : {0.9f * LEAST, 65505.0f, -65505.0f, 1e9f, INF}) {
        const Ktx2File file = write_levels({grey(value)});
        EXPECT_EQ(file.format, R32G32B32A32_SFLOAT) << value;
        EXPECT_EQ(file.type_size, 4u);
        EXPECT_EQ(file.channel(0, 5, 0, 0, 2), value);
        EXPECT_EQ(file.channel(0, 5, 0, 0, 3), 1.0f);
    }
    EXPECT_EQ(write_levels({grey(1.0f, 2), grey(1e9f)}).format, R32G32B32A32_SFLOAT);
    Image only_alpha = grey(1.0f);
    for (std::size_t i = 3; i < only_alpha.texels.size(); i += 4) only_alpha.texels[i] = 1e9f;
    EXPECT_EQ(write_levels({only_alpha}).format, R16G16B16A16_SFLOAT);
}

TEST_F(Ktx2WriteTest, RefusesWhatIsNoCubeMap) {
    expect_refused({}, "no image");
    expect_refused({{Layout::latlong, 4, 2, 1, std::vector<float>(32)}}, "cube maps");
    expect_refused({{Layout::cube, 4, 2, 6, std::vector<float>(192)}}, "square");
    Image short_image = grey(1.0f, 2);
    short_image.texels.pop_back();
    expect_refused({short_image}, "size");
    expect_refused({grey(1.0f, 4), grey(1.0f, 3)}, "half");
    expect_refused({grey(1.0f, 4), grey(1.0f, 4)}, "half");
    expect_refused({grey(1.0f), grey(1.0f)}, "half");
}

TEST_F(Ktx2WriteTest, RefusesKeysThatTheFormatDoesNotAllow) {
    expect_refused({grey(1)}, "\"\"", {{"", "x"}});
    expect_refused({grey(1)}, "\"a?b\"", {{"a\0b"s, "x"}});
    expect_refused({grey(1)}, "\"a\"", {{"a", "x\0y"s}});
    expect_refused({grey(1)}, "\"a\"", {{"a", "1"}, {"b", "1"}, {"a", "2"}});
    expect_refused({grey(1)}, "\"lobelia:sampling\"", {{"lobelia:sampling", "x"}});
    expect_refused({grey(1)}, "\"KTXswizzle\"", {{"KTXswizzle", "rgba"}});
    expect_refused({grey(1)}, "\"ktxa\"", {{"ktxa", "x"}});
}

} // namespace lobelia::test
