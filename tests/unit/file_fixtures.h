#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPixelType.h>

#include <gtest/gtest.h>

#include <lobelia/host/image.h>

namespace lobelia::test {

/// A test with a folder of its own, removed afterwards.
class FileTest : public testing::Test {
protected:
    FileTest();
    ~FileTest() override;

    std::string path(const std::string& name) const { return folder_ / name; }
    std::string write(const std::string& name, const std::string& bytes) const;
    std::size_t files() const; // in the folder

private:
    std::filesystem::path folder_;
};

std::string bytes_of(const std::string& path);

/// The path of a file of tests/corpus.
std::string corpus(const std::string& name);

/// A channel of an OpenEXR file to be made: `value` gives the texel at column x and row y, counted
/// from the top left of the data window.
struct Channel {
    std::string name;
    Imf::PixelType type = Imf::FLOAT;
    std::function<double(int x, int y)> value;
};

/// R, G and B of one type, with values that differ in every texel and that half can hold.
std::vector<Channel> colour_channels(Imf::PixelType type = Imf::FLOAT);

/// Writes a file with OpenEXR's C++ interface: tiled where the header says so (all levels alike),
/// in the header's window, compression and line order. The header's channels are made here.
void make_exr(const std::string& path, Imf::Header header, const std::vector<Channel>& channels);

/// What OpenEXR's C++ reader makes of R, G and B over the data window: an independent truth for
/// files that are not hostile.
std::vector<float> read_by_openexr(const std::string& path);

/// The colour of an image in file order, without alpha.
std::vector<float> colour_of(const host::Image& image);

} // namespace lobelia::test
