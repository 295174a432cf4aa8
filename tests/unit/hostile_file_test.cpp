#include <cmath>
#include <map>
#include <optional>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <OpenEXR/ImfTileDescription.h>

#include <lobelia/host/read.h>

#include "file_fixtures.h"

namespace lobelia::test {

using host::read_environment;

namespace {

// What is returned for a damaged file must still be radiance.
void expect_valid(const host::Environment& environment) {
    const host::Image& image = environment.image;
    ASSERT_EQ(image.texels.size(), std::size_t(image.width) * image.height * image.layers * 4);
    for (const float value : image.texels)
        if (!std::isfinite(value) || value < 0.0f) {
            ADD_FAILURE() << "returned " << value;
            return;
        }
}

double mean(const host::Image& image) {
    double sum = 0;
    for (const float value : colour_of(image)) sum += value;
    return sum / (double(image.texels.size()) * 0.75);
}

const std::vector<std::string>& compression_names() {
    static const std::vector<std::string> names{"none",  "rle", "zips", "zip",  "piz",
                                                "pxr24", "b44", "b44a", "dwaa", "dwab"};
    return names;
}

} // namespace

class HostileFileTest : public FileTest {
protected:
    // A small file of the compression, scanlines or tiles.
    std::string small_file(int compression, bool tiled, Imf::PixelType type = Imf::HALF) const {
        Imf::Header header(18, 9);
        header.compression() = Imf::Compression(compression);
        if (tiled) header.setTileDescription(Imf::TileDescription(16, 8));
        make_exr(path("small.exr"), header, colour_channels(type));
        return bytes_of(path("small.exr"));
    }
};

TEST_F(HostileFileTest, EveryFileOfTheCorpusIsReadRightOrRefused) {
    // The mean of the colour, or nothing for what is refused.
    const std::map<std::string, std::optional<double>> outcomes{{"17x9", 2},
                                                                {"1x1", 2},
                                                                {"2x2", 2},
                                                                {"ap1", 2},
                                                                {"chroma0", 2},
                                                                {"const", 1},
                                                                {"multi", 1},
                                                                {"over", 1},
                                                                {"rgba", 1},
                                                                {"tiled", 1},
                                                                {"r", 31.5},
                                                                {"y", 31.5},
                                                                {"crop", 21.0 * 16 / (64 * 32)},
                                                                {"sun1e9", 1e9 / (64 * 32)},
                                                                {"amp932", {}},
                                                                {"attr_1.85GB", {}},
                                                                {"deep", {}},
                                                                {"flip_143_7", {}},
                                                                {"layer", {}},
                                                                {"lie_100k", {}},
                                                                {"lie_16k", {}},
                                                                {"lie_1x2g", {}},
                                                                {"lie_20k", {}},
                                                                {"lie_2gx1", {}},
                                                                {"lie_71", {}},
                                                                {"lie_int", {}},
                                                                {"lie_inv", {}},
                                                                {"lie_max", {}},
                                                                {"neg", {}},
                                                                {"trunc_100", {}},
                                                                {"trunc_3", {}},
                                                                {"trunc_300", {}},
                                                                {"trunc_330", {}},
                                                                {"trunc_411", {}},
                                                                {"trunc_8", {}},
                                                                {"wide_1e6", {}},
                                                                {"wide_1e8", {}},
                                                                {"wide_1e9", {}},
                                                                {"wide_5e8", {}},
                                                                {"yc", {}},
                                                                {"z", {}}};
    for (const auto& [name, expected] : outcomes) {
        SCOPED_TRACE(name);
        const auto environment = read_environment(corpus(name + ".exr"));
        ASSERT_EQ(bool(environment), expected.has_value())
            << (environment ? "accepted" : environment.error().message);
        if (environment)
            EXPECT_NEAR(mean(environment->image), *expected, 1e-6 * *expected);
        else
            EXPECT_EQ(environment.error().message.find(corpus(name + ".exr") + ": "), 0u);
    }
}

TEST_F(HostileFileTest, CountsTheBadTexelsOfTheCorpus) {
    const auto environment = read_environment(corpus("bad.exr"));
    ASSERT_TRUE(environment) << environment.error().message;
    EXPECT_EQ(environment->sanitised.not_a_number, 1u);
    EXPECT_EQ(environment->sanitised.infinite, 2u);
    EXPECT_EQ(environment->sanitised.negative, 1u);
    expect_valid(*environment);
}

TEST_F(HostileFileTest, RefusalsCostLittleMemory) {
    for (const char* name : {"amp932", "attr_1.85GB", "flip_143_7", "lie_16k", "lie_20k", "lie_max",
                             "wide_1e9", "deep"}) {
        const pid_t child = ::fork();
        if (child == 0) {
            rusage before{};
            rusage after{};
            ::getrusage(RUSAGE_SELF, &before);
            const bool accepted = bool(read_environment(corpus(std::string(name) + ".exr")));
            ::getrusage(RUSAGE_SELF, &after);
            ::_exit(accepted || after.ru_maxrss - before.ru_maxrss > 16 * 1024);
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0) << name << " took more than 16 MB";
    }
}

TEST_F(HostileFileTest, RefusesAFileCutAtAnyByte) {
    std::vector<std::string> files{bytes_of(corpus("const.exr")), bytes_of(corpus("multi.exr"))};
    for (const int compression : {0, 3, 9})
        for (const bool tiled : {false, true}) files.push_back(small_file(compression, tiled));
    for (const std::string& whole : files) {
        ASSERT_TRUE(read_environment(write("whole.exr", whole)));
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const auto environment = read_environment(write("cut.exr", whole.substr(0, size)));
            EXPECT_FALSE(environment) << size << " of " << whole.size() << " bytes";
        }
    }
}

TEST_F(HostileFileTest, SurvivesABitFlippedAnywhere) {
    int mutants = 0;
    int accepted = 0;
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const bool tiled : {false, true}) {
            SCOPED_TRACE(compression_names()[std::size_t(compression)]);
            std::string bytes = small_file(compression, tiled, tiled ? Imf::FLOAT : Imf::HALF);
            for (std::size_t i = 0; i < bytes.size(); ++i)
                for (const int bit : {int(i % 8), 7}) {
                    bytes[i] = char(bytes[i] ^ (1 << bit));
                    const auto environment = read_environment(write("flip.exr", bytes));
                    if (environment) expect_valid(*environment);
                    accepted += bool(environment);
                    ++mutants;
                    bytes[i] = char(bytes[i] ^ (1 << bit));
                }
        }
    EXPECT_GT(mutants, 842);
    EXPECT_GT(accepted, 0); // else the unharmed file was not read either
    RecordProperty("mutants", mutants);
    RecordProperty("accepted", accepted);
}

TEST_F(HostileFileTest, RefusesAHeaderThatLiesAboutTheSizeInEveryCompression) {
    const std::string attribute("dataWindow\0box2i\0\x10\0\0\0", 21);
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const bool tiled : {false, true})
            for (const std::size_t corner : {8u, 12u}) // the right edge, the lower edge
                for (const int more : {7, 100, 16000}) {
                    SCOPED_TRACE(compression_names()[std::size_t(compression)]);
                    std::string bytes = small_file(compression, tiled);
                    const std::size_t at = bytes.find(attribute) + attribute.size() + corner;
                    const int edge = (corner == 8 ? 17 : 8) + more;
                    bytes[at] = char(edge & 0xff);
                    bytes[at + 1] = char(edge >> 8);
                    EXPECT_FALSE(read_environment(write("lie.exr", bytes)))
                        << "tiled " << tiled << " corner " << corner << " more " << more;
                }
}

TEST_F(HostileFileTest, RefusesWhatIsNotARegularFileWithoutWaiting) {
    ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
    ASSERT_EQ(::symlink("loop", path("loop").c_str()), 0);
    for (const std::string& name :
         {path("fifo"), path("loop"), path(""), path("none"), write("empty", ""),
          write("text", "hello\n"), std::string("/dev/zero"), std::string("/dev/null")}) {
        const auto environment = read_environment(name);
        ASSERT_FALSE(environment) << name;
        EXPECT_EQ(environment.error().message.find(name + ": "), 0u) << environment.error().message;
    }
}

TEST_F(HostileFileTest, HoldsTheLimitsOfTheCall) {
    const std::string file = write("small.exr", small_file(3, false));
    EXPECT_TRUE(read_environment(file, {.side = 18, .texels = 18 * 9, .channels = 3, .parts = 1}));
    EXPECT_FALSE(read_environment(file, {.file_bytes = 100}));
    EXPECT_FALSE(read_environment(file, {.side = 17}));
    EXPECT_FALSE(read_environment(file, {.texels = 18 * 9 - 1}));
    EXPECT_FALSE(read_environment(file, {.channels = 2}));
    EXPECT_FALSE(read_environment(file, {.attribute_bytes = 200}));
    EXPECT_FALSE(read_environment(corpus("multi.exr"), {.parts = 1}));
    EXPECT_FALSE(read_environment(write("dwa.exr", small_file(9, false)), {.decoder_bytes = 0}));
}

TEST_F(HostileFileTest, AMessageIsOneLineWhateverTheNamesHold) {
    const auto nowhere = read_environment(path("a\nb\x1b[2J.exr"));
    ASSERT_FALSE(nowhere);
    const auto strange = [this] {
        make_exr(path("strange.exr"), Imf::Header(2, 1),
                 {{"evil\n\x1b]0;", Imf::HALF, [](int, int) { return 0.0; }}});
        return read_environment(path("strange.exr"));
    }();
    ASSERT_FALSE(strange);
    for (const std::string& message : {nowhere.error().message, strange.error().message})
        for (const char c : message) EXPECT_GE(c, ' ') << message;
}

} // namespace lobelia::test
