#include <lobelia/host/write.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <tuple>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

#include "host/descriptor.h"
#include "host/guard.h"
#include "host/message.h"
#include "host/quiet_signals.h"
#include "host/temporary_files.h"

namespace lobelia::host {

namespace {

constexpr int MOST_LINKS = 40; // in a chain, as in Linux
constexpr std::size_t CHECKED_AT_ONCE = std::size_t(1) << 20;

Failure cannot(const char* step) {
    return {std::string("cannot be ") + step + " (" + system_message() +
            "), free some space or choose another place"};
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

// The path at the end of a chain of symbolic links, whether or not there is a file.
Outcome<std::string> follow_links(std::string path) {
    for (int i = 0; i < MOST_LINKS; ++i) {
        std::vector<char> link(PATH_MAX);
        const ssize_t length = ::readlink(path.c_str(), link.data(), link.size());
        if (length < 0) return path; // not a link, or not there: opening it will tell
        const std::string target(link.data(), std::size_t(length));
        path = target.starts_with('/') ? target : folder_of(path) + target;
    }
    errno = ELOOP;
    return cannot("written");
}

bool write_all(const Descriptor& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file.get(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count == 0) errno = EIO; // no progress, and no reason given
        if (count <= 0) return false;
        bytes = bytes.subspan(std::size_t(count));
    }
    return true;
}

bool holds(const Descriptor& file, std::span<const std::byte> bytes) {
    std::vector<std::byte> found(std::min(CHECKED_AT_ONCE, bytes.size() + 1));
    std::size_t offset = 0;
    for (;;) {
        const ssize_t count = ::pread(file.get(), found.data(), found.size(), off_t(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        if (count == 0) return offset == bytes.size();
        if (std::size_t(count) > bytes.size() - offset ||
            std::memcmp(found.data(), bytes.data() + offset, std::size_t(count)) != 0) {
            errno = EIO;
            return false;
        }
        offset += std::size_t(count);
    }
}

Outcome<Done> write_beside(const std::string& path, const struct stat* replaced,
                           std::span<const std::byte> bytes) {
    const std::string folder = folder_of(path);
    sweep_temporary_files(folder);
    TemporaryFile temporary(folder);
    if (!temporary.exists()) return cannot("created");
    // Only kept where the file system has permissions at all; the file is as good without.
    if (replaced) std::ignore = ::fchmod(temporary.file().get(), replaced->st_mode & 0777);
    if (!write_all(temporary.file(), bytes) || ::fsync(temporary.file().get()) != 0)
        return cannot("written");
    if (!holds(temporary.file(), bytes)) return cannot("read back after writing");
    if (!temporary.close()) return cannot("written");
    if (!temporary.take_name(path)) return cannot("replaced");
    // The content is safe; this only hastens the name's way to the disk.
    const Descriptor opened(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened) std::ignore = ::fsync(opened.get());
    return Done{};
}

Outcome<Done> write_straight(const std::string& path, std::span<const std::byte> bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (!file) return cannot("opened for writing");
    if (!write_all(file, bytes) || !file.close()) return cannot("written");
    return Done{};
}

Outcome<Done> replace(const std::string& given, std::span<const std::byte> bytes) {
    const Outcome<std::string> path = follow_links(given);
    if (!path) return path.error();
    struct stat state {};
    if (::stat(path->c_str(), &state) != 0) return write_beside(*path, nullptr, bytes);
    if (S_ISDIR(state.st_mode)) return Failure{"is a folder, give a file name in it"};
    if (S_ISREG(state.st_mode)) return write_beside(*path, &state, bytes);
    return write_straight(*path, bytes);
}

} // namespace

Outcome<Done> replace_file(const std::string& path, std::span<const std::byte> bytes) {
    return guarded([&]() -> Outcome<Done> {
        const QuietSignals quiet;
        const Outcome<Done> replaced = replace(path, bytes);
        if (!replaced) return about(path, replaced.error());
        return Done{};
    });
}

} // namespace lobelia::host
