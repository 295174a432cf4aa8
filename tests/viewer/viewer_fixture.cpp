#include "viewer_fixture.h"

#include <algorithm>
#include <cstdlib>

namespace lobelia::test {

void ViewerTest::expect_good_end(ViewerSession& session) {
    session.key("ctrl+q");
    EXPECT_EQ(session.child().wait(std::chrono::seconds(60)), 0);
    session.read_rest();
    EXPECT_EQ(session.child().errors(), "");
    EXPECT_TRUE(session.strays().empty()) << session.strays().front();
}

PngFile ViewerTest::seen(ViewerSession& session) {
    const std::string path = folder / "seen.png";
    desktop.run({"import", "-window", session.window(), "-depth", "8", "PNG32:" + path});
    return read_png(path);
}

int largest_difference(const PngFile& a, const PngFile& b, std::uint32_t first,
                       std::uint32_t last) {
    if (a.width != b.width || a.height != b.height) return 256;
    int largest = 0;
    for (std::uint32_t y = 0; y < a.height; ++y)
        for (std::uint32_t x = first; x < last; ++x)
            for (std::uint32_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(int(a.at(x, y)[c]) - int(b.at(x, y)[c])));
    return largest;
}

} // namespace lobelia::test
