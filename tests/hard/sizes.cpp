#include <cstring>

#include <lobelia/host/read.h>

#include "files.h"
#include "gpu/panorama_fixture.h"

// C01 to C07: sizes of images.
namespace lobelia::hard {
namespace {

using host::Environment;
using host::read_environment;
using test::colour_channels;
using test::corpus;
using test::TemporaryFolder;

void kept(Bench& bench, Findings& found, std::uint32_t width, std::uint32_t height) {
    found.at(std::to_string(width) + " x " + std::to_string(height));
    for (std::uint32_t face : {3u, 16u}) {
        const host::Image even = bench.cube(even_panorama(width, height, 1, 2, 3), face);
        found.holds(even.texels == even_cube(face, 1, 2, 3).texels, "constant light stays");
        const host::Image panorama = test::noise({width, height}, width + height);
        const Rgb before = test::mean(panorama);
        const Rgb after = test::mean(bench.cube(panorama, face));
        for (std::size_t c = 0; c < 3; ++c) found.near(after[c], before[c], 1e-4);
    }
    for (const Average& average :
         bench.exact(even_panorama(width, height, 1, 2, 3), 16, axes(4, 81)))
        for (std::size_t c = 0; c < 3; ++c)
            found.near(double(average[c]), double(c + 1), SUMMATION);
}

void one_texel(Bench& bench, Findings& found) {
    kept(bench, found, 1, 1);
    found.at("from a file");
    found.holds(plain_mean(read(corpus("1x1.exr")).image) == 2, "1x1.exr is 2 everywhere");
}
void few_texels(Bench& bench, Findings& found) {
    for (auto [width, height] :
         {std::pair{2u, 1u}, {1u, 2u}, {2u, 2u}, {3u, 2u}, {1u, 64u}, {64u, 1u}})
        kept(bench, found, width, height);
}
void odd_sizes(Bench& bench, Findings& found) {
    kept(bench, found, 17, 9);
    kept(bench, found, 301, 151);
    kept(bench, found, 1023, 511);
}

void other_aspects(Bench& bench, Findings& found) {
    kept(bench, found, 64, 64);
    kept(bench, found, 300, 100);
    const TemporaryFolder folder;
    found.at("a file of 20 x 20");
    const Environment square = read(make_file(folder, colour_channels(), [](Imf::Header& header) {
        header.dataWindow() = header.displayWindow() = {{0, 0}, {19, 19}};
    }));
    found.holds(square.notices.size() == 1 &&
                    square.notices[0].find("not twice as wide as high") != std::string::npos,
                "one notice says so");
}

// A header for that many texels and nothing behind it but a table of chunks.
std::string header_alone(const TemporaryFolder& folder, int width, int height) {
    std::string bytes = test::bytes_of(corpus("const.exr"));
    for (const char* name : {"dataWindow", "displayWindow"}) {
        const std::size_t at = bytes.find(std::string(name) + '\0') + std::string(name).size() + 1 +
                               6 + 4; // type "box2i", size
        const std::int32_t edges[4] = {0, 0, width - 1, height - 1};
        std::memcpy(&bytes[at], edges, sizeof edges);
    }
    test::write_bytes(folder / "header.exr", bytes);
    return folder / "header.exr";
}

void largest_allowed(Bench&, Findings& found) {
    const TemporaryFolder folder;
    found.at("16384 x 8192 with a table for 32 rows");
    cheaply_refused(found, header_alone(folder, 16384, 8192));
    found.at("the same under a limit of its own");
    found.refused(read_environment(corpus("const.exr"), {.texels = 64 * 32 - 1}), "2047 texels");
}
void too_large(Bench&, Findings& found) {
    const TemporaryFolder folder;
    for (auto [width, height] :
         {std::pair{32768, 16384}, {32769, 1}, {1, 32769}, {16385, 8192}, {2147483647, 1}}) {
        found.at(std::to_string(width) + " x " + std::to_string(height));
        cheaply_refused(found, header_alone(folder, width, height));
    }
}
void no_width(Bench&, Findings& found) {
    const TemporaryFolder folder;
    for (auto [width, height] : {std::pair{0, 32}, {64, 0}, {0, 0}, {-5, 32}}) {
        found.at(std::to_string(width) + " x " + std::to_string(height));
        cheaply_refused(found, header_alone(folder, width, height));
    }
    found.at("Radiance");
    test::write_bytes(folder / "a.hdr", "#?RADIANCE\n\n-Y 0 +X 4\n");
    cheaply_refused(found, folder / "a.hdr", "no texels");
}

} // namespace

Kind image_sizes() {
    return {"Sizes of images",
            {
                {"C01", "1 x 1", "constant light; the mean is kept", one_texel},
                {"C02", "2 x 1, 1 x 2, 2 x 2, 3 x 2, 1 x 64, 64 x 1", "the same", few_texels},
                {"C03", "17 x 9, 301 x 151, 1023 x 511", "the same", odd_sizes},
                {"C04", "64 x 64, 300 x 100", "covers the sphere all the same, with a notice",
                 other_aspects},
                {"C05", "16384 x 8192, the most that is read",
                 "a short file that claims it is refused", largest_allowed},
                {"C06", "32768 x 16384 and other sizes above the limits",
                 "refused within 50 ms and 16 MB", too_large},
                {"C07", "no width, no height, less than none", "refused", no_width},
            }};
}

} // namespace lobelia::hard
