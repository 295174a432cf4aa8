#include <lobelia/host/write.h>

#include <cstddef>
#include <exception>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "host/cube_layout.h"
#include "host/exr_stream.h"
#include "host/guard.h"
#include "host/image_shape.h"
#include "host/message.h"

namespace lobelia::host {

namespace {

constexpr std::size_t LONGEST_NAME = 255; // of an attribute in OpenEXR

Outcome<Done> check(std::span<const Part> parts, Content content, const Metadata& metadata) {
    if (parts.empty()) return Failure{"cannot be written: there is no image"};
    for (const Part& part : parts) {
        if (!part.image) return Failure{"cannot be written: a part has no image"};
        if (parts.size() > 1 && part.name.empty())
            return Failure{"cannot be written: one of several parts has no name"};
        const Outcome<Done> fits = content == Content::environment ? check_environment(*part.image)
                                                                   : check_texels(*part.image);
        if (!fits) return fits.error();
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (parts[i].name == parts[j].name)
                return Failure{"cannot be written: two parts are called \"" +
                               printable(parts[i].name) + "\""};
    for (const auto& [name, value] : metadata)
        if (name.empty() || name.size() > LONGEST_NAME)
            return Failure{"cannot be written: \"" + printable(name) +
                           "\" is no name for an attribute"};
    return Done{};
}

bool is_cube(const Image& image, Content content) {
    return content == Content::environment && image.layout == Layout::cube;
}

// The texels in file order with the size that they have there.
Imf::Header make_header(const Part& part, Content content, const Metadata& metadata) {
    const bool cube = is_cube(*part.image, content);
    Imf::Header header(int(part.image->width), int(part.image->height * (cube ? 6 : 1)));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel());
    if (content == Content::picture) header.channels().insert("A", Imf::Channel());
    for (const char* channel : {"R", "G", "B", "A"})
        if (Imf::Channel* found = header.channels().findChannel(channel)) found->type = Imf::FLOAT;
    if (!part.name.empty()) header.setName(part.name);
    if (content == Content::environment) {
        Imf::addEnvmap(header, cube ? Imf::ENVMAP_CUBE : Imf::ENVMAP_LATLONG);
        header.insert("lobelia:sampling", Imf::StringAttribute("texel centres"));
    }
    for (const auto& [name, value] : metadata) header.insert(name, Imf::StringAttribute(value));
    return header;
}

Imf::FrameBuffer make_frame(const float* texels, std::uint32_t width, Content content) {
    const std::size_t channels = content == Content::picture ? 4 : 3;
    constexpr const char* NAMES[] = {"R", "G", "B", "A"};
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels; ++c) {
        // OpenEXR has one type for reading and writing; writing leaves the texels as they are.
        char* base = reinterpret_cast<char*>(const_cast<float*>(texels + c));
        frame.insert(NAMES[c], Imf::Slice(Imf::FLOAT, base, 4 * sizeof(float),
                                          4 * sizeof(float) * std::size_t(width)));
    }
    return frame;
}

// `File` is OpenEXR's writer of a file with one part, or of one part of a file with several.
template <class File>
void write_texels(File& file, const Part& part, Content content) {
    const bool cube = is_cube(*part.image, content);
    const Image faces = cube ? exr_layout_from_cube(*part.image) : Image{};
    const Image& image = cube ? faces : *part.image;
    file.setFrameBuffer(make_frame(image.texels.data(), image.width, content));
    file.writePixels(int(image.height));
}

std::vector<std::byte> encode(std::span<const Part> parts, Content content,
                              const Metadata& metadata) {
    MemoryOStream stream;
    if (parts.size() == 1) {
        Imf::OutputFile file(stream, make_header(parts[0], content, metadata), 0);
        write_texels(file, parts[0], content);
    } else {
        std::vector<Imf::Header> headers;
        Imath::Box2i display; // one for all parts; an image of its own size is its data window
        for (const Part& part : parts) {
            headers.push_back(make_header(part, content, metadata));
            headers.back().setType(Imf::SCANLINEIMAGE);
            display.extendBy(headers.back().dataWindow());
        }
        for (Imf::Header& header : headers) header.displayWindow() = display;
        Imf::MultiPartOutputFile file(stream, headers.data(), int(headers.size()), false, 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Imf::OutputPart output(file, int(i));
            write_texels(output, parts[i], content);
        }
    }
    return stream.take(); // the writers put their tables in place when they go
}

} // namespace

Outcome<Done> write_exr(const std::string& path, std::span<const Part> parts, Content content,
                        const Metadata& metadata) {
    return guarded([&]() -> Outcome<Done> {
        const Outcome<Done> checked = check(parts, content, metadata);
        if (!checked) return about(path, checked.error());
        try {
            return replace_file(path, encode(parts, content, metadata));
        } catch (const std::exception& error) {
            return about(path, {"cannot be encoded (" + printable(error.what()) + ")"});
        }
    });
}

} // namespace lobelia::host
