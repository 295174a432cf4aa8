#include "cli_fixture.h"

#include <algorithm>

#include <lobelia/host/write.h>

namespace lobelia::test {

ProgramCall CliTest::call(const Arguments& arguments) const {
    ProgramCall result{.command = {LOBELIA_PROGRAM}, .folder = folder.path()};
    result.command.insert(result.command.end(), arguments.begin(), arguments.end());
    return result;
}

std::string CliTest::run_well(const Arguments& arguments) const {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << "signal " << result.signal;
    EXPECT_EQ(result.err, "");
    return result.out;
}

std::string CliTest::write_panorama(const std::string& name) const {
    host::Image image{.width = 32, .height = 16};
    for (std::uint32_t i = 0; i < image.width * image.height; ++i)
        image.texels.insert(image.texels.end(), {0.25f, 0.5f, 0.75f, 1.0f});
    const host::Part part{.image = &image};
    const auto written = host::write_exr(folder / name, {&part, 1}, host::Content::environment);
    EXPECT_TRUE(written) << written.error().message;
    return folder / name;
}

void expect_refused(const ProgramResult& result, int status, const std::string& words) {
    EXPECT_EQ(result.status, status) << "signal " << result.signal << ", stderr: " << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(result.err.starts_with("lobelia: ")) << result.err;
    EXPECT_TRUE(result.err.ends_with("\n")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
}

} // namespace lobelia::test
