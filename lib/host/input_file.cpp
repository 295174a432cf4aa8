#include "host/input_file.h"

#include <cerrno>

#include <fcntl.h>

#include "host/message.h"

namespace lobelia::host {

namespace {

const char* kind_of_file(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

} // namespace

Outcome<InputFile> InputFile::open(const std::string& path, std::uint64_t limit) {
    // Not blocking, since opening a pipe would otherwise wait for a writer.
    Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!descriptor) return Failure{"cannot be opened (" + system_message() + "), check the path"};
    struct stat state {};
    if (::fstat(descriptor.get(), &state) != 0)
        return Failure{"cannot be examined (" + system_message() + ")"};
    if (!S_ISREG(state.st_mode))
        return Failure{std::string("is ") + kind_of_file(state.st_mode) +
                       ", give an OpenEXR or Radiance .hdr file"};
    if (state.st_size == 0) return Failure{"is empty, export it again"};
    if (std::uint64_t(state.st_size) > limit)
        return Failure{"is larger than the limit of " + std::to_string(limit) +
                       " bytes, reduce the image"};
    return InputFile(std::move(descriptor), state);
}

std::int64_t InputFile::read_at(std::uint64_t offset, std::span<std::byte> into) const {
    std::size_t done = 0;
    if (offset >= size()) return 0; // also keeps offsets that off_t cannot hold from pread
    while (done < into.size()) {
        const ssize_t count = ::pread(descriptor_.get(), into.data() + done, into.size() - done,
                                      off_t(offset + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return -1;
        if (count == 0) break;
        done += std::size_t(count);
    }
    return std::int64_t(done);
}

bool InputFile::unchanged() const {
    struct stat now {};
    return ::fstat(descriptor_.get(), &now) == 0 && now.st_size == state_.st_size &&
           now.st_mtim.tv_sec == state_.st_mtim.tv_sec &&
           now.st_mtim.tv_nsec == state_.st_mtim.tv_nsec;
}

} // namespace lobelia::host
