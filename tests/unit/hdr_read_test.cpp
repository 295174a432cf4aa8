#include <array>
#include <cmath>

#include <lobelia/host/read.h>

#include "file_fixtures.h"

namespace lobelia::test {

using host::read_environment;

namespace {

// A texel of value (x + 1, y + 1, 128) / 128.
std::string texel(int x, int y) {
    return {char(x + 1), char(y + 1), char(128), char(129)};
}

std::string header(const std::string& resolution, const std::string& variables = "") {
    return "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n" + variables + "\n" + resolution +
           "\n";
}

} // namespace

class HdrReadTest : public FileTest {
protected:
    auto read(const std::string& bytes, const host::ReadLimits& limits = {}) const {
        return read_environment(write("a.hdr", bytes), limits);
    }
    std::vector<float> colour(const std::string& bytes) const {
        const auto environment = read(bytes);
        if (environment) return colour_of(environment->image);
        ADD_FAILURE() << environment.error().message;
        return {};
    }
};

TEST_F(HdrReadTest, EveryOrientationGivesTheSameMap) {
    constexpr int width = 6, height = 3;
    std::vector<float> expected;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x + 1, y + 1, 128}) expected.push_back(float(value) / 128.0f);

    for (const bool columns : {false, true})
        for (const bool flip_x : {false, true})
            for (const bool flip_y : {false, true}) {
                const std::string x_axis = std::string(flip_x ? "-X " : "+X ") + "6";
                const std::string y_axis = std::string(flip_y ? "+Y " : "-Y ") + "3";
                std::string bytes = header(columns ? x_axis + " " + y_axis : y_axis + " " + x_axis);
                for (int i = 0; i < (columns ? width : height); ++i)
                    for (int j = 0; j < (columns ? height : width); ++j) {
                        const int x = columns ? i : j;
                        const int y = columns ? j : i;
                        bytes += texel(flip_x ? width - 1 - x : x, flip_y ? height - 1 - y : y);
                    }
                EXPECT_EQ(colour(bytes), expected) << x_axis << " " << y_axis << " " << columns;
            }
}

TEST_F(HdrReadTest, ReadsRunsLiteralsAndFlatTexelsAlike) {
    const std::string start = header("-Y 1 +X 8");
    std::string flat = start;
    for (int i = 0; i < 8; ++i) flat += texel(0, 0);
    const std::string old_runs = start + texel(0, 0) + std::string("\1\1\1\7", 4);
    // Per component: a run of 8, or a run of 5 and three literals.
    const std::string new_runs =
        start + std::string("\2\2\0\10", 4) + "\x88\1" + "\x85\1\3\1\1\1" + "\x88\x80" + "\x88\x81";
    EXPECT_EQ(colour(old_runs), colour(flat));
    EXPECT_EQ(colour(new_runs), colour(flat));
}

TEST_F(HdrReadTest, CountsLongOldRunsByHigherBytes) {
    // 1 + 0 + 1 * 256 + 2 texels: a run of 256, another texel and a run of one.
    const std::string bytes = header("-Y 1 +X 259") + texel(0, 0) + std::string("\1\1\1\0", 4) +
                              std::string("\1\1\1\1", 4) + texel(1, 0) + std::string("\1\1\1\1", 4);
    const std::vector<float> values = colour(bytes);
    ASSERT_EQ(values.size(), 259u * 3);
    EXPECT_EQ(values[256 * 3], 1.0f / 128);
    EXPECT_EQ(values[257 * 3], 2.0f / 128);
    EXPECT_EQ(values[258 * 3], 2.0f / 128);
}

TEST_F(HdrReadTest, ReadsLinesTooLongForNewRuns) {
    const std::string bytes =
        header("-Y 1 +X 32768") + texel(0, 0) + std::string("\1\1\1\xff\1\1\1\x7f", 8);
    EXPECT_EQ(colour(bytes).size(), 32768u * 3);
}

TEST_F(HdrReadTest, ScalesByExponentAndDividesByEveryExposure) {
    const auto value = [&](char exponent, const std::string& variables) {
        const std::string bytes =
            header("-Y 1 +X 1", variables) + std::string("\x80\x80\x80", 3) + exponent;
        return colour(bytes).at(0);
    };
    EXPECT_EQ(value(char(129), ""), 1.0f);
    EXPECT_EQ(value(char(129), "EXPOSURE=2\n"), 0.5f);
    EXPECT_EQ(value(char(129), "EXPOSURE= 2.0\nEXPOSURE=4e0\r\n"), 0.125f);
    EXPECT_EQ(value(char(255), ""), std::ldexp(1.0f, 126));
    EXPECT_EQ(value(char(1), ""), std::ldexp(1.0f, -128)); // below the normal floats
    EXPECT_EQ(value(char(0), ""), 0.0f);
}

TEST_F(HdrReadTest, NotesWhatItDoesNotApply) {
    const auto environment =
        read(header("-Y 1 +X 2", "GAMMA=2.2\nCOLORCORR=1 2 3\n") + texel(0, 0) + texel(0, 0));
    ASSERT_TRUE(environment) << environment.error().message;
    EXPECT_EQ(environment->notices.size(), 2u);
}

TEST_F(HdrReadTest, RefusesWhatItCannotRead) {
    const std::string one = texel(0, 0);
    const std::array<std::string, 18> files{
        "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + one,
        "#?RADIANCE\nFORMAT=ascii\n\n-Y 1 +X 1\n" + one,
        "#?OTHER\n\n-Y 1 +X 1\n" + one,
        header("-Y 1 +X 1", "EXPOSURE=0\n") + one,
        header("-Y 1 +X 1", "EXPOSURE=-1\n") + one,
        header("-Y 1 +X 1", "EXPOSURE=nan\n") + one,
        header("-Y 1 +X 1", "EXPOSURE=1e-300\nEXPOSURE=1e-300\n") + one,
        header("-Y 1 +X 1", "COMMENT=" + std::string(5000, 'x') + "\n") + one,
        header("-Y 0 +X 1"),
        header("-Y 1 -Y 1") + one,
        header("-Y 99999999999 +X 1") + one,
        header("-Y 40000 +X 1") + one,
        header("-Y 1 +X 1 +Z 1") + one,
        header("-Y 1 +X 2") + std::string("\1\1\1\1", 4) + one, // repeats nothing
        header("-Y 1 +X 2") + one + std::string("\1\1\1\2", 4), // past the row
        header("-Y 1 +X 8") + std::string("\2\2\0\11", 4) + std::string(64, '\1'), // other width
        header("-Y 1 +X 8") + std::string("\2\2\0\10\0\0\0\0", 8) +
            std::string(64, '\0'), // zero run
        header("-Y 1 +X 8") + std::string("\2\2\0\10", 4) + "\x89\1" + std::string(64, '\1'),
    };
    for (const std::string& bytes : files) {
        const auto environment = read(bytes);
        ASSERT_FALSE(environment) << bytes.substr(0, 200);
        EXPECT_NE(environment.error().message.find("a.hdr: "), std::string::npos);
    }
    EXPECT_FALSE(read(header("-Y 2 +X 2") + one + one + one + one, {.texels = 3}));
}

TEST_F(HdrReadTest, RefusesAFileCutAtAnyByteAndSurvivesFlips) {
    std::string whole = header("-Y 2 +X 8", "EXPOSURE=1.5\n");
    for (int i = 0; i < 2; ++i)
        whole +=
            std::string("\2\2\0\10", 4) + "\x88\1" + "\x85\1\3\1\1\1" + "\x88\x80" + "\x88\x81";
    ASSERT_TRUE(read(whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(read(whole.substr(0, size))) << size;
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = whole;
            flipped[i] = char(flipped[i] ^ (1 << bit));
            const auto environment = read(flipped);
            if (!environment) continue;
            for (const float value : environment->image.texels)
                ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << i << " " << bit;
        }
}

TEST_F(HdrReadTest, AShortFileThatClaimsToBeLargeIsRefused) {
    EXPECT_FALSE(read(header("-Y 8192 +X 16384") + texel(0, 0)));
}

} // namespace lobelia::test
