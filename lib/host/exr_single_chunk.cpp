#include "host/exr_single_chunk.h"

#include <array>
#include <exception>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include "host/exr_stream.h"
#include "host/message.h"

namespace lobelia::host {

namespace {

Imf::Header make_header(const ExrPart& part, const exr_chunk_info_t& chunk) {
    Imf::Header header(chunk.width, chunk.height);
    header.compression() = Imf::Compression(int(part.compression));
    for (const ExrChannel& channel : part.channels)
        header.channels().insert(
            channel.name, Imf::Channel(Imf::PixelType(int(channel.type)), 1, 1, channel.linear));
    if (part.tiled)
        header.setTileDescription(
            Imf::TileDescription(unsigned(chunk.width), unsigned(chunk.height), Imf::ONE_LEVEL));
    return header;
}

void append_number(MemoryOStream& file, std::uint64_t value, int bytes) {
    std::array<char, sizeof value> little_endian{};
    for (int i = 0; i < bytes; ++i) little_endian[std::size_t(i)] = char(value >> (8 * i) & 0xff);
    file.write(little_endian.data(), bytes);
}

// A whole OpenEXR file (magic, version, header, table of one chunk, chunk) around `packed`.
std::vector<std::byte> make_file(const ExrPart& part, const exr_chunk_info_t& chunk,
                                 std::span<const std::byte> packed) {
    MemoryOStream file;
    append_number(file, std::uint64_t(Imf::MAGIC), 4);
    append_number(
        file,
        std::uint64_t(Imf::EXR_VERSION | Imf::LONG_NAMES_FLAG | (part.tiled ? Imf::TILED_FLAG : 0)),
        4);
    make_header(part, chunk).writeTo(file, part.tiled);
    append_number(file, file.tellp() + 8, 8);
    const int coordinates = part.tiled ? 4 : 1; // tile x, y, level x, y; or the first scanline
    for (int i = 0; i < coordinates; ++i) append_number(file, 0, 4);
    append_number(file, packed.size(), 4);
    file.write(reinterpret_cast<const char*>(packed.data()), int(packed.size()));
    return file.take();
}

} // namespace

Outcome<Done> decode_single_chunk(const ExrPart& part, const ExrChunk& chunk,
                                  std::span<const std::byte> packed, std::span<float> texels) {
    try {
        const std::vector<std::byte> bytes = make_file(part, chunk.info, packed);
        MemoryIStream stream(bytes);
        Imf::InputFile file(stream, 0);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < part.colour.size(); ++c)
            frame.insert(part.channels[part.colour[c]].name,
                         Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(texels.data() + c),
                                    4 * sizeof(float),
                                    4 * sizeof(float) * std::size_t(chunk.info.width)));
        file.setFrameBuffer(frame);
        file.readPixels(0, chunk.info.height - 1);
    } catch (const std::exception& error) {
        return Failure{" (" + printable(error.what()) + ")"};
    }
    return Done{};
}

} // namespace lobelia::host
