#include <lobelia/host/read.h>

#include <array>
#include <exception>

#include "host/exr_read.h"
#include "host/guard.h"
#include "host/hdr_read.h"
#include "host/input_file.h"
#include "host/message.h"
#include "host/sanitise.h"

namespace lobelia::host {

namespace {

constexpr std::array<std::byte, 4> EXR_MAGIC{std::byte{0x76}, std::byte{0x2f}, std::byte{0x31},
                                             std::byte{0x01}};

Outcome<Environment> read_any(const std::string& path, const ReadLimits& limits) {
    const Outcome<InputFile> file = InputFile::open(path, limits.file_bytes);
    if (!file) return file.error();
    std::array<std::byte, EXR_MAGIC.size()> magic{};
    if (file->read_at(0, magic) < 0) return Failure{"cannot be read (" + system_message() + ")"};

    Environment environment;
    Outcome<Image> image = magic == EXR_MAGIC ? read_exr(*file, limits, environment.notices)
                                              : read_hdr(*file, limits, environment.notices);
    if (!image) return image.error();
    if (!file->unchanged()) return Failure{"changed while it was read, try again"};
    environment.image = std::move(*image);
    const Outcome<Sanitised> sanitised = sanitise(environment.image);
    if (!sanitised) return sanitised.error();
    environment.sanitised = *sanitised;
    return environment;
}

} // namespace

Outcome<Environment> read_environment(const std::string& path, const ReadLimits& limits) {
    return guarded([&]() -> Outcome<Environment> {
        // The standard library and OpenEXR throw when memory runs out.
        try {
            Outcome<Environment> environment = read_any(path, limits);
            if (!environment) return about(path, environment.error());
            for (std::string& notice : environment->notices) notice = about(path, {notice}).message;
            return environment;
        } catch (const std::exception& error) {
            return about(path, {std::string("cannot be read (") + error.what() +
                                "), close other programs or reduce the image"});
        }
    });
}

} // namespace lobelia::host
