#include <cstring>
#include <filesystem>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <lobelia/host/read.h>

#include "files.h"

// D: hostile files.
namespace lobelia::hard {
namespace {

using host::read_environment;
using test::colour_channels;
using test::corpus;
using test::TemporaryFolder;

void refused_files(Findings& found, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        found.at(name);
        cheaply_refused(found, corpus(std::string(name) + ".exr"));
    }
}

void amplifier(Bench&, Findings& found) {
    refused_files(found, {"amp932"});
}
void attribute_size(Bench&, Findings& found) {
    refused_files(found, {"attr_1.85GB"});
}

void bomb(Bench&, Findings& found) {
    // Zeros shrink to a thousandth: what decoding may cost is settled before.
    const TemporaryFolder folder;
    const std::string file = make_file(
        folder, {{"Y", Imf::HALF, [](int, int) { return 0.0; }}}, [](Imf::Header& header) {
            header.dataWindow() = header.displayWindow() = {{0, 0}, {4095, 255}};
            header.compression() = Imf::ZIP_COMPRESSION;
        });
    found.at("within the limits");
    const auto environment = read_environment(file);
    found.holds(environment && environment->image.width == 4096, "is read");
    found.at("above a limit on texels");
    found.refused(read_environment(file, {.texels = 1 << 19}), "524288 texels");
    found.at("above a limit on the file");
    found.refused(read_environment(file, {.file_bytes = 100}), "limit of 100 bytes");
}

void wider_than_said(Bench&, Findings& found) {
    refused_files(found, {"lie_71", "lie_16k", "lie_2gx1"});
}
void taller_than_said(Bench&, Findings& found) {
    refused_files(found, {"lie_20k", "lie_100k", "lie_1x2g"});
}
void extreme_windows(Bench&, Findings& found) {
    refused_files(found, {"lie_int", "lie_max", "lie_inv", "neg"});
}
void million_wide(Bench&, Findings& found) {
    refused_files(found, {"wide_1e6", "wide_1e8", "wide_5e8", "wide_1e9", "flip_143_7"});
}

void cut(Bench&, Findings& found) {
    refused_files(found,
                  {"trunc_3", "trunc_8", "trunc_100", "trunc_300", "trunc_330", "trunc_411"});
}

void flipped_bits(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string bytes = test::bytes_of(corpus("const.exr"));
    found.at("a bit of each byte of const.exr");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string flipped = bytes;
        flipped[i] = char(flipped[i] ^ (1 << i % 8));
        test::write_bytes(folder / "flip.exr", flipped);
        const auto environment = read_environment(folder / "flip.exr");
        if (environment) found.sound(environment->image.texels);
    }
}

void crowds(Bench&, Findings& found) {
    const TemporaryFolder folder;
    std::vector<test::Channel> many;
    for (int i = 0; i < 65; ++i)
        many.push_back({"c" + std::to_string(i), Imf::HALF, [](int, int) { return 1.0; }});
    found.at("65 channels");
    cheaply_refused(found, make_file(folder, many), "65 channels");

    found.at("17 parts");
    std::vector<Imf::Header> headers;
    for (int i = 0; i < 17; ++i) {
        headers.emplace_back(2, 1);
        headers.back().setName("p" + std::to_string(i));
        headers.back().setType(Imf::SCANLINEIMAGE);
        headers.back().channels().insert("Y", Imf::Channel(Imf::HALF));
    }
    Imf::MultiPartOutputFile((folder / "parts.exr").c_str(), headers.data(), 17);
    cheaply_refused(found, folder / "parts.exr", "17 parts");

    found.at("an attribute of 2 MB");
    const std::string large = make_file(folder, colour_channels(), [](Imf::Header& header) {
        header.insert("comments", Imf::StringAttribute(std::string(2 << 20, 'x')));
    });
    cheaply_refused(found, large, "headers of more than 1048576 bytes");

    found.at("10000 attributes");
    const std::string crowded = make_file(folder, colour_channels(), [](Imf::Header& header) {
        for (int i = 0; i < 10000; ++i)
            header.insert("a" + std::to_string(i), Imf::StringAttribute("x"));
    });
    cheaply_refused(found, crowded);
}

// Where a file's table of chunks begins: after the header's last zero byte.
std::size_t table_of(const std::string& bytes, std::size_t chunks) {
    const std::int32_t first_line = 0;
    std::uint64_t first = 0;
    for (std::size_t at = 8; at + 8 * chunks < bytes.size(); ++at) {
        std::memcpy(&first, &bytes[at], sizeof first);
        if (first == at + 8 * chunks && std::memcmp(&bytes[first], &first_line, 4) == 0) return at;
    }
    throw std::runtime_error("no table of chunks");
}

void chunk_tables(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string whole =
        test::bytes_of(make_file(folder, colour_channels(), [](Imf::Header& header) {
            header.compression() = Imf::NO_COMPRESSION;
        }));
    const std::size_t table = table_of(whole, HEIGHT);
    const auto entry = [&](std::size_t i) { return table + 8 * i; };
    const auto with = [&](std::size_t i, std::uint64_t offset) {
        std::string bytes = whole;
        std::memcpy(&bytes[entry(i)], &offset, sizeof offset);
        test::write_bytes(folder / "table.exr", bytes);
        return folder / "table.exr";
    };
    std::uint64_t first = 0;
    std::memcpy(&first, &whole[entry(0)], sizeof first);
    for (const auto& [name, offset] :
         {std::pair<const char*, std::uint64_t>{"into the table", table},
          {"to another line", first},
          {"to the file's end", whole.size()},
          {"outside", whole.size() + 1000},
          {"far outside", std::uint64_t(1) << 62},
          {"nowhere", 0},
          {"beyond counting", UINT64_MAX}}) {
        found.at(name);
        cheaply_refused(found, with(3, offset));
    }
}

void duplicates(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string bytes = test::bytes_of(corpus("const.exr"));
    const std::size_t at = bytes.find(std::string("lineOrder\0lineOrder", 19));
    found.at("pixelAspectRatio twice");
    std::string twice = bytes;
    const std::string ratio("pixelAspectRatio\0float\0\4\0\0\0\0\0\x80\x3f", 31);
    twice.insert(at, ratio);
    test::write_bytes(folder / "twice.exr", twice);
    // The chunks moved by as much, so that the table is wrong, too: either way an error.
    cheaply_refused(found, folder / "twice.exr");
}

// Whether OpenEXR's C++ interface takes a picture so wide.
bool openexr_takes(int width) {
    try {
        Imf::Header header(width, 2);
        header.channels().insert("Y", Imf::Channel(Imf::HALF));
        header.sanityCheck();
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

void no_process_settings(Bench&, Findings& found) {
    // A limit that this process has set, and its threads, stay as they are.
    Imf::Header::setMaxImageSize(1000, 1000);
    Imf::setGlobalThreadCount(3);
    for (const auto& entry : std::filesystem::directory_iterator(LOBELIA_CORPUS_FOLDER)) {
        found.at(entry.path().filename());
        (void)read_environment(entry.path());
        found.holds(openexr_takes(1000) && !openexr_takes(1001), "the limit is as it was");
        found.holds(Imf::globalThreadCount() == 3, "so are the threads");
    }
    Imf::Header::setMaxImageSize(0, 0);
    Imf::setGlobalThreadCount(0);
}

} // namespace

Kind hostile_files() {
    return {"Hostile files",
            {
                {"D01", "932 bytes that make other readers take 1.6 GB",
                 "refused within 50 ms and 16 MB", amplifier},
                {"D02", "an attribute that says it has 1.85 GB", "the same", attribute_size},
                {"D03", "a picture that shrinks to a thousandth",
                 "its cost is limited before it is decoded", bomb},
                {"D04", "windows wider than the data", "the same", wider_than_said},
                {"D05", "windows taller than the data", "the same", taller_than_said},
                {"D06", "windows at the ends of the numbers, inverted, negative", "the same",
                 extreme_windows},
                {"D07", "files cut at any byte", "refused, no part of a picture", cut,
                 "HostileFileTest.RefusesAFileCutAtAnyByte"},
                {"D08", "a bit flipped in each byte", "refused, or finite radiance", flipped_bits,
                 "HostileFileTest.SurvivesABitFlippedAnywhere"},
                {"D09", "a million wide and more, of 421 bytes", "refused within 50 ms and 16 MB",
                 million_wide},
                {"D10", "65 channels, 17 parts, an attribute of 2 MB, 10000 attributes",
                 "refused by count and size", crowds},
                {"D11", "a table of chunks that points anywhere", "refused", chunk_tables},
                {"D12", "an attribute twice", "refused", duplicates},
                {"D13", "every file of the corpus, read or refused",
                 "OpenEXR's process-wide settings are as they were", no_process_settings},
            }};
}

} // namespace lobelia::hard
