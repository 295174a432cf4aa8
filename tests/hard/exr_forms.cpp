#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include "files.h"

// C08 to C25: what an OpenEXR file may hold.
namespace lobelia::hard {
namespace {

using host::Environment;
using test::Channel;
using test::colour_channels;
using test::corpus;
using test::TemporaryFolder;

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

} // namespace

Kind exr_forms() {
    return {"Forms of OpenEXR files",
            {
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
            }};
}

} // namespace lobelia::hard
