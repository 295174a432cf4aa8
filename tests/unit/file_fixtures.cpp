#include "file_fixtures.h"

#include <fstream>
#include <sstream>

#include <stdlib.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

namespace lobelia::test {

FileTest::FileTest() {
    std::string name = std::filesystem::temp_directory_path() / "lobelia-test-XXXXXX";
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
}

FileTest::~FileTest() {
    std::filesystem::remove_all(folder_);
}

std::string FileTest::write(const std::string& name, const std::string& bytes) const {
    std::filesystem::remove(path(name)); // writing over a file can make it wait for the disk
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
}

std::size_t FileTest::files() const {
    const std::filesystem::directory_iterator entries(folder_);
    return std::size_t(std::distance(begin(entries), end(entries)));
}

std::string bytes_of(const std::string& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

std::string corpus(const std::string& name) {
    return LOBELIA_CORPUS_FOLDER "/" + name;
}

std::vector<Channel> colour_channels(Imf::PixelType type) {
    return {{"R", type, [](int x, int y) { return x + 32 * y; }},
            {"G", type, [](int x, int y) { return 0.5 + x + y; }},
            {"B", type, [](int x, int y) { return 1024 - x - 32 * y; }}};
}

namespace {

// One channel's texels in its own type, and where OpenEXR finds them.
std::vector<std::uint32_t> plane_of(const Channel& channel, const Imath::Box2i& window) {
    std::vector<std::uint32_t> plane;
    for (int y = 0; y <= window.max.y - window.min.y; ++y)
        for (int x = 0; x <= window.max.x - window.min.x; ++x) {
            const double value = channel.value(x, y);
            std::uint32_t bits = 0;
            if (channel.type == Imf::HALF)
                bits = half(float(value)).bits();
            else if (channel.type == Imf::UINT)
                bits = std::uint32_t(value);
            else
                bits = std::bit_cast<std::uint32_t>(float(value));
            plane.push_back(bits);
        }
    return plane;
}

} // namespace

void make_exr(const std::string& path, Imf::Header header, const std::vector<Channel>& channels) {
    const Imath::Box2i window = header.dataWindow();
    std::vector<std::vector<std::uint32_t>> planes;
    Imf::FrameBuffer frame;
    for (const Channel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(channel.type));
        planes.push_back(plane_of(channel, window));
        frame.insert(channel.name, Imf::Slice::Make(channel.type, planes.back().data(), window,
                                                    sizeof(std::uint32_t)));
    }
    if (!header.hasTileDescription()) {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(window.max.y - window.min.y + 1);
        return;
    }
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    for (int y = 0; y < file.numYLevels(); ++y)
        for (int x = 0; x < file.numXLevels(); ++x)
            if (file.isValidLevel(x, y))
                file.writeTiles(0, file.numXTiles(x) - 1, 0, file.numYTiles(y) - 1, x, y);
}

std::vector<float> read_by_openexr(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    std::vector<float> colour(std::size_t(width) * std::size_t(height) * 3);
    Imf::FrameBuffer frame;
    std::size_t offset = 0;
    for (const char* channel : {"R", "G", "B"})
        frame.insert(channel,
                     Imf::Slice::Make(Imf::FLOAT, &colour[offset++], window, 3 * sizeof(float),
                                      3 * sizeof(float) * std::size_t(width)));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return colour;
}

std::vector<float> colour_of(const host::Image& image) {
    std::vector<float> colour;
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        if (i % 4 != 3) colour.push_back(image.texels[i]);
    return colour;
}

} // namespace lobelia::test
