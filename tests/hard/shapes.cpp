#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <lobelia/host/read.h>

#include "files.h"
#include "gpu/panorama_fixture.h"

// C: shapes and formats of images.
namespace lobelia::hard {
namespace {

using host::Environment;
using host::read_environment;
using test::Channel;
using test::colour_channels;
using test::corpus;
using test::TemporaryFolder;

Environment read(const std::string& path) {
    return value_of(read_environment(path));
}

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

void luminance(Bench& bench, Findings& found) {
    const TemporaryFolder folder;
    for (Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
        found.at("Y of type " + std::to_string(type));
        const Environment grey =
            read(make_file(folder, {{"Y", type, [](int, int) { return 1.0; }}}));
        for (const Average& average : bench.exact(grey.image, 16, axes(4, 82)))
            for (std::size_t c = 0; c < 3; ++c) found.near(double(average[c]), 1, SUMMATION);
    }
    found.at("y.exr");
    found.near(plain_mean(read(corpus("y.exr")).image), 31.5, 1e-6);
}

void some_colours(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const auto channel = [](const char* name) {
        return Channel{name, Imf::FLOAT, [](int x, int) { return 1.0 + x; }};
    };
    found.at("R");
    const Environment red = read(make_file(folder, {channel("R")}));
    found.holds(red.notices.size() == 1, "grey, with a notice");
    found.near(plain_mean(red.image), 1 + (WIDTH - 1) / 2.0, 1e-6);
    found.at("R and G");
    cheaply_refused(found, make_file(folder, {channel("R"), channel("G")}), "G R");
    for (const char* name : {"G", "B", "A"}) {
        found.at(name);
        cheaply_refused(found, make_file(folder, {channel(name)}), name);
    }
}

void no_colour(Bench&, Findings& found) {
    found.at("z.exr");
    cheaply_refused(found, corpus("z.exr"), "Z");
}
void layers(Bench&, Findings& found) {
    found.at("layer.exr");
    cheaply_refused(found, corpus("layer.exr"), "diffuse");
}

void read_as_one(Findings& found, const char* name, double mean) {
    found.at(name);
    const Environment environment = read(corpus(name));
    found.sound(environment.image.texels);
    found.near(plain_mean(environment.image), mean, 1e-6);
}
void with_alpha(Bench&, Findings& found) {
    read_as_one(found, "rgba.exr", 1);
}
void subsampled(Bench&, Findings& found) {
    found.at("yc.exr");
    cheaply_refused(found, corpus("yc.exr"));
}

// The file gives what OpenEXR's own reader gives of it.
void as_openexr(Findings& found, const std::string& path) {
    const Environment environment = read(path);
    std::vector<float> truth = test::read_by_openexr(path);
    for (float& value : truth) value = std::max(value, 0.0f); // lossy compressions undershoot
    found.holds(test::colour_of(environment.image) == truth, "what OpenEXR reads");
}

void whole_numbers(Bench&, Findings& found) {
    const TemporaryFolder folder;
    found.at("UINT");
    as_openexr(found, make_file(folder, colour_channels(Imf::UINT)));
}
void mixed_types(Bench&, Findings& found) {
    const TemporaryFolder folder;
    for (std::size_t odd = 0; odd < 3; ++odd)
        for (Imf::PixelType type : {Imf::HALF, Imf::UINT}) {
            found.at("channel " + std::to_string(odd) + " of type " + std::to_string(type));
            std::vector<Channel> channels = colour_channels(Imf::FLOAT);
            channels[odd].type = type;
            as_openexr(found, make_file(folder, channels));
        }
}
void tiles(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const Environment lines = read(make_file(folder, colour_channels()));
    for (Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS})
        for (unsigned width : {8u, 20u, 64u}) {
            found.at("tiles of " + std::to_string(width) + " x 4, levels of kind " +
                     std::to_string(mode));
            const Environment tiled =
                read(make_file(folder, colour_channels(), [&](Imf::Header& header) {
                    header.setTileDescription({width, 4, mode});
                }));
            found.holds(tiled.image.texels == lines.image.texels, "the bytes of scan lines");
        }
}

void second_part(Bench&, Findings& found) {
    read_as_one(found, "multi.exr", 1);
}
void deep_file(Bench&, Findings& found) {
    found.at("deep.exr");
    cheaply_refused(found, corpus("deep.exr"));
}
void cropped(Bench&, Findings& found) {
    read_as_one(found, "crop.exr", 21.0 * 16 / (64 * 32));
}
void overscan(Bench&, Findings& found) {
    read_as_one(found, "over.exr", 1);
}
void far_windows(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const Environment near = read(make_file(folder, colour_channels()));
    for (int corner : {-1'000'000'000, -7, 1'000'000'000}) {
        found.at("from " + std::to_string(corner));
        const Environment far = read(make_file(folder, colour_channels(), [&](Imf::Header& header) {
            header.dataWindow() = header.displayWindow() = {
                {corner, corner}, {corner + WIDTH - 1, corner + HEIGHT - 1}};
        }));
        found.holds(far.image.texels == near.image.texels, "the same bytes");
    }
}
void primaries(Bench&, Findings& found) {
    for (const char* name : {"ap1.exr", "chroma0.exr"}) {
        read_as_one(found, name, 2);
        found.holds(read(corpus(name)).notices.size() >= 1, "a notice says so");
    }
}

void compressions(Bench&, Findings& found) {
    const TemporaryFolder folder;
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
            found.at("method " + std::to_string(compression) + ", type " + std::to_string(type));
            as_openexr(found, make_file(folder, colour_channels(type), [&](Imf::Header& header) {
                           header.compression() = Imf::Compression(compression);
                       }));
        }
    found.at("a method of the future");
    std::string bytes = test::bytes_of(corpus("const.exr"));
    const std::string attribute("compression\0compression\0\1\0\0\0", 28);
    bytes[bytes.find(attribute) + attribute.size()] = 12;
    test::write_bytes(folder / "new.exr", bytes);
    cheaply_refused(found, folder / "new.exr", "compressed by a method");
}

void line_orders(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const Environment upright = read(make_file(folder, colour_channels()));
    for (Imf::LineOrder order : {Imf::DECREASING_Y, Imf::RANDOM_Y})
        for (bool tiled : {false, true}) {
            if (order == Imf::RANDOM_Y && !tiled) continue; // is for tiles alone
            found.at("order " + std::to_string(order) + (tiled ? ", tiles" : ", lines"));
            const Environment other =
                read(make_file(folder, colour_channels(), [&](Imf::Header& header) {
                    header.lineOrder() = order;
                    if (tiled) header.setTileDescription(Imf::TileDescription(8, 4));
                }));
            found.holds(other.image.texels == upright.image.texels, "the same bytes");
        }
}

void stated_maps(Bench&, Findings& found) {
    const TemporaryFolder folder;
    found.at("a cube map");
    const Environment cube = read(make_file(folder, colour_channels(), [](Imf::Header& header) {
        header.dataWindow() = header.displayWindow() = {{0, 0}, {3, 23}};
        Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
    }));
    found.holds(cube.image.layers == 6 && cube.image.width == 4, "six faces of 4");
    found.at("a cube map of another shape");
    cheaply_refused(found, make_file(folder, colour_channels(), [](Imf::Header& header) {
                        Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
                    }));
    const Environment plain = read(make_file(folder, colour_channels()));
    for (float aspect : {0.5f, 2.0f}) {
        found.at("pixels of aspect " + text(aspect));
        const Environment odd = read(make_file(folder, colour_channels(), [&](Imf::Header& header) {
            header.pixelAspectRatio() = aspect;
            header.screenWindowWidth() = 3;
        }));
        found.holds(odd.image.texels == plain.image.texels, "the same bytes");
    }
}

std::string radiance(const std::string& resolution, const std::string& variables = "") {
    // Each texel another mantissa, in file order.
    std::string bytes = "#?RADIANCE\n" + variables + "\n" + resolution + "\n";
    for (int i = 0; i < 2 * 3; ++i) bytes += {char(10 + i), char(50 + i), char(90 + i), char(128)};
    return bytes;
}

void orientations(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const auto of = [&](const std::string& resolution) {
        test::write_bytes(folder / "a.hdr", radiance(resolution));
        return read(folder / "a.hdr").image;
    };
    // Of the picture's texel (x, y), the number in file order.
    const auto look = [&](const std::string& resolution, std::uint32_t width, std::uint32_t height,
                          auto number) {
        found.at(resolution);
        const host::Image image = of(resolution);
        found.holds(image.width == width && image.height == height, "size");
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                found.holds(*image.texel(0, x, y) == float(10 + number(x, y)) / 256, "texel");
    };
    look("-Y 2 +X 3", 3, 2, [](auto x, auto y) { return y * 3 + x; });
    look("-Y 2 -X 3", 3, 2, [](auto x, auto y) { return y * 3 + 2 - x; });
    look("+Y 2 +X 3", 3, 2, [](auto x, auto y) { return (1 - y) * 3 + x; });
    look("+Y 2 -X 3", 3, 2, [](auto x, auto y) { return (1 - y) * 3 + 2 - x; });
    look("+X 3 -Y 2", 3, 2, [](auto x, auto y) { return x * 2 + y; });
    look("-X 3 -Y 2", 3, 2, [](auto x, auto y) { return (2 - x) * 2 + y; });
    look("+X 3 +Y 2", 3, 2, [](auto x, auto y) { return x * 2 + 1 - y; });
    look("-X 3 +Y 2", 3, 2, [](auto x, auto y) { return (2 - x) * 2 + 1 - y; });
    found.at("XYZE");
    test::write_bytes(folder / "a.hdr", radiance("-Y 2 +X 3", "FORMAT=32-bit_rle_xyze\n"));
    cheaply_refused(found, folder / "a.hdr", "XYZ");
}

void variables(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& lines) {
        test::write_bytes(folder / "a.hdr", radiance("-Y 2 +X 3", lines));
        return folder / "a.hdr";
    };
    const double plain = plain_mean(read(with("")).image);
    found.at("EXPOSURE, twice");
    found.near(plain_mean(read(with("EXPOSURE=4\nEXPOSURE=0.5\n")).image), plain / 2, 1e-6);
    for (const char* name : {"GAMMA", "COLORCORR", "PRIMARIES"}) {
        found.at(name);
        const Environment noted = read(with(std::string(name) + "=2.2\n"));
        found.near(plain_mean(noted.image), plain, 1e-6);
        found.holds(noted.notices.size() >= 1, "a notice says that it is ignored");
    }
    found.at("10000 lines");
    std::string many;
    for (int i = 0; i < 10000; ++i) many += "VIEW=-vp 0 0 0\n";
    found.near(plain_mean(read(with(many)).image), plain, 1e-6);
    for (const std::string& bad :
         {std::string("EXPOSURE=0\n"), std::string("EXPOSURE=nan\n"), std::string("EXPOSURE=-1\n"),
          std::string("A=") + std::string(5000, 'x') + "\n", std::string("FORMAT=png\n")}) {
        found.at(bad.substr(0, 20));
        cheaply_refused(found, with(bad));
    }
}

void broken_runs(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string head = "#?RADIANCE\n\n-Y 1 +X 16\n";
    const std::string line("\2\2\0\20", 4);
    for (const auto& [name, bytes] :
         {std::pair<const char*, std::string>{"a run of nothing", line + std::string("\0\1", 2)},
          {"a run past the line", line + std::string("\xff\1", 2)},
          {"literals past the line", line + std::string("\x11") + std::string(17, 'a')},
          {"a line of another length", std::string("\2\2\0\10", 4) + std::string(64, '\1')},
          {"a repeat at the beginning", std::string("\1\1\1\7", 4) + std::string(64, '\1')},
          {"cut in a line", line + std::string("\x90\1\x90\1", 4)},
          {"cut before the line", std::string()}}) {
        found.at(name);
        test::write_bytes(folder / "a.hdr", head + bytes);
        cheaply_refused(found, folder / "a.hdr", "truncated or damaged");
    }
}

void no_pictures(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string fifo = folder / "fifo", loop = folder / "loop";
    found.holds(::mkfifo(fifo.c_str(), 0600) == 0 && ::symlink("loop", loop.c_str()) == 0, "made");
    test::write_bytes(folder / "empty", "");
    test::write_bytes(folder / "text.exr", "hello\n");
    for (const std::string& path :
         {fifo, loop, folder.path(), folder / "none", folder / "empty", folder / "text.exr",
          std::string("/dev/zero"), std::string("/dev/null")}) {
        found.at(path == folder.path() ? "a folder" : std::filesystem::path(path).filename());
        cheaply_refused(found, path);
    }
    found.at("an OpenEXR file called .hdr");
    std::filesystem::copy_file(corpus("const.exr"), folder / "a.hdr");
    found.near(plain_mean(read(folder / "a.hdr").image), 1, 1e-6);
}

void changing_file(Bench&, Findings& found) {
    // Shortened and restored all the while: what comes back is whole or refused.
    const TemporaryFolder folder;
    const std::string whole = test::bytes_of(make_file(folder, colour_channels()));
    const std::vector<float> texels = read(folder / "a.exr").image.texels;
    std::atomic<bool> stop = false;
    std::thread other([&] {
        while (!stop) {
            if (::truncate((folder / "a.exr").c_str(), off_t(whole.size() / 2)) != 0) return;
            test::write_bytes(folder / "a.exr", whole);
        }
    });
    found.at("200 reads");
    bool sound = true;
    for (int i = 0; i < 200; ++i) {
        const auto environment = read_environment(folder / "a.exr");
        sound = sound && (!environment || environment->image.texels == texels);
    }
    stop = true;
    other.join();
    found.holds(sound, "never a part");
}

} // namespace

Kind image_shapes() {
    return {"Shapes and formats of images",
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
                {"C08", "Y alone", "grey", luminance},
                {"C09", "R alone, R and G, G, B, A",
                 "red is grey, with a notice; others are refused", some_colours},
                {"C10", "Z alone", "refused, naming the channels", no_colour},
                {"C11", "layers alone", "refused, naming them", layers},
                {"C12", "R, G, B and A", "A means nothing", with_alpha},
                {"C13", "luminance and subsampled chroma", "refused", subsampled},
                {"C14", "whole numbers", "what OpenEXR reads", whole_numbers},
                {"C15", "channels of different types", "what OpenEXR reads", mixed_types},
                {"C16", "tiles, mipmaps, ripmaps", "the bytes of scan lines", tiles},
                {"C17", "colour in the second part", "is found", second_part},
                {"C18", "deep data", "refused", deep_file},
                {"C19", "data within the display window", "black around it", cropped},
                {"C20", "data beyond the display window", "cropped", overscan},
                {"C21", "windows 1e9 from the origin", "the same bytes", far_windows},
                {"C22", "other primaries, or none", "values are kept, with a notice", primaries},
                {"C23", "ten compressions of two types; an unknown one",
                 "what OpenEXR reads; refused", compressions},
                {"C24", "lines in decreasing order, tiles in any", "the same bytes", line_orders},
                {"C25", "a stated cube map; odd pixels and screen windows",
                 "six faces, or refused; they mean nothing", stated_maps},
                {"C26", "Radiance's eight orientations; XYZE", "each texel in its place; refused",
                 orientations},
                {"C27", "Radiance's variables, many, long, unusable", "applied, noted or refused",
                 variables},
                {"C28", "Radiance runs that are empty, too long, cut", "refused", broken_runs},
                {"C29", "pipes, loops, folders, devices, empty files, another ending",
                 "refused without waiting; content decides, not the ending", no_pictures},
                {"C30", "a file that another program shortens and restores", "whole or refused",
                 changing_file},
            }};
}

} // namespace lobelia::hard
