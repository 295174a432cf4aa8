#include <filesystem>
#include <ostream>

#include "cli_fixture.h"

namespace lobelia::test {

namespace {

using Names = std::vector<std::string>;

// What is asked, how it ends, and what the message names.
struct BadInput {
    const char* name;
    std::vector<std::string> arguments;
    int status;
    const char* words;
};

void PrintTo(const BadInput& input, std::ostream* out) {
    *out << input.name;
}

const BadInput BAD_INPUTS[] = {
    {"NoVerb", {}, 2, "lobelia -h"},
    {"UnknownVerb", {"paint"}, 2, "lobelia -h"},
    {"UnknownOption", {"render", "--shininess", "3"}, 2, "--shininess"},
    {"BlurOfNoBackground", {"render", "--blur", "8", "--no-background"}, 2, "--blur"},
    {"UnknownQuality", {"render", "--quality", "best"}, 2, "fast, normal and high"},
    {"MissingValue", {"render", "--kd"}, 2, "--kd"},
    {"EmptyValue", {"render", "--kd", ""}, 2, "--kd"},
    {"OptionTwice", {"render", "-n", "1", "-n", "2"}, 2, "-n"},
    {"TwoEnvironments", {"render", "a.exr", "b.exr"}, 2, "b.exr"},
    {"TrailingLetters", {"render", "-n", "1e3x"}, 2, "\"1e3x\""},
    {"LeadingSpace", {"render", "-n", " 5"}, 2, "\" 5\""},
    {"HexadecimalNumber", {"render", "-n", "0x10"}, 2, "\"0x10\""},
    {"CommaForAPoint", {"render", "-n", "0,5"}, 2, "\"0,5\""},
    {"TwoNumbersForAColour", {"render", "--kd", "0,5"}, 2, "\"0,5\""},
    {"FourNumbersForAColour", {"render", "--kd", "0,0,0,1"}, 2, "\"0,0,0,1\""},
    {"HoleInAVector", {"render", "--eye", "1,,2"}, 2, "--eye"},
    {"NotANumber", {"render", "-n", "nan"}, 2, "1e6"},
    {"Infinity", {"render", "-n", "inf"}, 2, "1e6"},
    {"NumberBeyondFloat", {"render", "-n", "1e999"}, 2, "1e6"},
    {"NotANumberInAVector", {"render", "--eye", "0,nan,0"}, 2, "--eye"},
    {"InfiniteExposure", {"render", "--exposure", "-inf"}, 2, "--exposure"},
    {"OneSide", {"render", "--size", "512"}, 2, "\"512\""},
    {"NegativeSide", {"render", "--size", "5x-5"}, 2, "\"5x-5\""},
    {"SideBeyondCounting", {"render", "--size", "99999999999x1"}, 2, "\"99999999999x1\""},
    {"UnknownMethod", {"render", "--method", "magic"}, 2, "split-sum"},
    {"SamplesOfSplitSum", {"render", "--samples", "8"}, 2, "--method importance"},
    {"HalfASample", {"render", "--method", "importance", "--samples", "0.5"}, 2, "\"0.5\""},
    {"UnknownEnding", {"render", "-o", "a.jpg"}, 2, "a.jpg"},
    {"NoExponents", {"prefilter", "a.exr", "-o", "b.exr"}, 2, "--exponents"},
    {"SameExponentTwice", {"prefilter", "a.exr", "-o", "b.exr", "--exponents", "8,8.0"}, 2, "8"},
    {"NoOutput", {"prefilter", "a.exr", "--lambert"}, 2, "-o"},
    {"MapAsPng", {"prefilter", "a.exr", "--lambert", "-o", "b.png"}, 2, "b.png"},
    {"MapOfUnknownEnding", {"prefilter", "a.exr", "--lambert", "-o", "b.dds"}, 2, ".ktx2"},
    {"PictureAsKtx2", {"render", "-o", "a.ktx2"}, 2, "a.ktx2"},
    {"UnknownMapFormat",
     {"prefilter", "a.exr", "--lambert", "-o", "b.exr", "--format", "png"},
     2,
     "exr and ktx2"},
    {"MapFormatOfAnotherEnding",
     {"prefilter", "a.exr", "--lambert", "-o", "b.exr", "--format", "ktx2"},
     2,
     "end the name in .ktx2"},
    {"MapFormatOfAPicturesEnding",
     {"prefilter", "a.exr", "--lambert", "-o", "b.png", "--format", "exr"},
     2,
     "end the name in .exr"},
    {"PanoramaAsKtx2",
     {"prefilter", "a.exr", "--lambert", "-o", "b.ktx2", "--layout", "latlong"},
     2,
     "--layout"},
    {"FaceOfAPanorama",
     {"prefilter", "a.exr", "--lambert", "-o", "b.exr", "--layout", "latlong", "--face", "8"},
     2,
     "--face"},
    {"UnknownPrefilterMethod",
     {"prefilter", "a.exr", "--lambert", "-o", "b.exr", "--method", "magic"},
     2,
     "chain, importance, filtered-importance and exact"},
    {"SamplesOfTheChain",
     {"prefilter", "a.exr", "--lambert", "-o", "b.exr", "--samples", "8"},
     2,
     "--samples"},

    {"NegativeBlur", {"render", "--blur", "-1"}, 1, "background's blur"},
    {"NegativeExponent", {"render", "-n", "-1"}, 1, "-1"},
    {"ExponentBeyondTheLimit", {"render", "-n", "1e7"}, 1, "1000000"},
    {"NegativeDiffuse", {"render", "--kd", "0,-0.5,0"}, 1, "-0.5"},
    {"EnergyGain", {"render", "--kd", "0.8", "--ks", "0.3"}, 1, "kd"},
    {"NegativeDespiteAllowance", {"render", "--ks", "-1", "--allow-energy-gain"}, 1, "-1"},
    {"NoPixels", {"render", "--size", "0x16"}, 1, "0"},
    {"PictureBeyondTheDevice", {"render", "--size", "4000000000x1"}, 1, "4000000000"},
    {"CameraAtItsTarget", {"render", "--eye", "0,0,2", "--target", "0,0,2"}, 1, "lobelia"},
    {"UpAlongTheView", {"render", "--up", "0,0,1"}, 1, "up"},
    {"FieldOfViewOfAHalfTurn", {"render", "--fov", "180"}, 1, "180"},
    {"NoSamples", {"render", "--method", "importance", "--samples", "0"}, 1, "1024"},
    {"TooManySamples", {"render", "--method", "importance", "--samples", "1025"}, 1, "1024"},
    {"UnknownDevice", {"render", "--device", "abacus"}, 1, "abacus"},
    {"MissingFile", {"render", "nowhere.exr"}, 1, "nowhere.exr"},
    {"FolderAsFile", {"render", "/"}, 1, "/"},
    {"EndlessFile", {"render", "/dev/zero"}, 1, "/dev/zero"},
    {"MissingFolder", {"render", "-o", "nowhere/a.exr"}, 1, "nowhere/a.exr"},
    {"MissingFileToPrefilter", {"prefilter", "no.exr", "--lambert", "-o", "b.exr"}, 1, "no.exr"},
};

class BadInputTest : public CliTest, public testing::WithParamInterface<BadInput> {};

std::string name_of(const testing::TestParamInfo<BadInput>& info) {
    return info.param.name;
}

class StrangersFileTest : public CliTest {
protected:
    // Either it is refused and nothing is left, or it is a picture; never anything else.
    void expect_picture_or_refusal(const std::string& path) const {
        SCOPED_TRACE(path);
        const ProgramResult result = run({"render", path, "--size", "8x8", "-o", "a.exr"});
        if (result.status == 0) {
            EXPECT_EQ(folder.names(), Names{"a.exr"});
            std::filesystem::remove(folder / "a.exr");
        } else {
            expect_refused(result, 1, path);
            EXPECT_EQ(folder.names(), Names{});
        }
    }
};

} // namespace

TEST_P(BadInputTest, IsRefusedInOneLineAndLeavesNothing) {
    expect_refused(run(GetParam().arguments), GetParam().status, GetParam().words);
    EXPECT_EQ(folder.names(), Names{});
}

INSTANTIATE_TEST_SUITE_P(Cli, BadInputTest, testing::ValuesIn(BAD_INPUTS), name_of);

TEST_F(StrangersFileTest, IsRefusedOrShown) {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(LOBELIA_CORPUS_FOLDER)) {
        expect_picture_or_refusal(file.path().string());
        ++count;
    }
    EXPECT_GT(count, 0u);
}

TEST_F(StrangersFileTest, IsRefusedWhereverItIsCut) {
    const std::string whole = read_bytes(write_panorama("whole.exr"));
    std::filesystem::remove(folder / "whole.exr");
    TemporaryFolder inputs;
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 8) {
        const std::string path = inputs / "cut.exr";
        write_bytes(path, whole.substr(0, size));
        expect_refused(run({"render", path, "-o", "a.exr"}), 1, path);
        EXPECT_EQ(folder.names(), Names{});
    }
}

TEST_F(StrangersFileTest, CannotWriteOverTheTerminalThroughItsName) {
    const ProgramResult result = run({"render", "two\nlines\x1b[2J.exr"});
    expect_refused(result, 1, "two?lines?[2J.exr");
}

} // namespace lobelia::test
