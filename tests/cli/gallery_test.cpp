#include <filesystem>

#include "cli_fixture.h"

// The figures themselves take minutes, nearly all of them the reference's: they are made by hand.
namespace lobelia::test {
namespace {

class GalleryVerb : public CliTest {};

TEST_F(GalleryVerb, SaysWhatItIsMissingBeforeItBegins) {
    expect_refused(run({"gallery"}), 2, "-o");
    expect_refused(run({"gallery", "--quick", "-o", "out"}), 2, "--quick");
    ProgramCall without = call({"gallery", "-o", "out"});
    without.environment = {{"PATH", folder.path()}};
    expect_refused(run_program(without), 1, "ImageMagick");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

} // namespace
} // namespace lobelia::test
