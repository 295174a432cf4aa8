#include "host/temporary_files.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace lobelia::host {

namespace {

constexpr int MOST_ATTEMPTS = 10'000; // at a name that nothing has yet
constexpr std::string_view PREFIX = ".lobelia-", SUFFIX = ".tmp";

bool is_temporary(std::string_view name) {
    if (name.size() < PREFIX.size() + SUFFIX.size() || !name.starts_with(PREFIX) ||
        !name.ends_with(SUFFIX))
        return false;
    name.remove_prefix(PREFIX.size());
    name.remove_suffix(SUFFIX.size());
    return name.find_first_not_of("0123456789-") == std::string_view::npos;
}

void remove_if_nobody_writes(const std::string& path) {
    // Not blocking and no link: a stranger may have made what has such a name.
    const Descriptor file(
        ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY));
    struct stat state {};
    if (!file || ::fstat(file.get(), &state) != 0 || !S_ISREG(state.st_mode)) return;
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return;
    // What was opened may have taken its last name since, and another writer's file this one. Who
    // holds the lock of the file that has the name keeps it.
    struct stat named {};
    if (::lstat(path.c_str(), &named) == 0 && named.st_dev == state.st_dev &&
        named.st_ino == state.st_ino)
        ::unlink(path.c_str());
}

} // namespace

TemporaryFile::TemporaryFile(const std::string& folder) {
    const std::string stem = folder + std::string(PREFIX) + std::to_string(::getpid()) + "-";
    for (int i = 0; i < MOST_ATTEMPTS && !exists_; ++i) {
        name_ = stem + std::to_string(i) + std::string(SUFFIX);
        file_ = Descriptor(::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (file_)
            exists_ = claim();
        else if (errno != EEXIST)
            return;
    }
}

// False where somebody swept the file away before it was locked. Without locks nobody sweeps.
bool TemporaryFile::claim() {
    claim_ = Descriptor(::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0));
    struct stat state {};
    return ::flock(claim_.get(), LOCK_EX) != 0 || ::fstat(claim_.get(), &state) != 0 ||
           state.st_nlink > 0;
}

TemporaryFile::~TemporaryFile() {
    if (exists_) ::unlink(name_.c_str());
}

bool TemporaryFile::take_name(const std::string& path) {
    const bool taken = std::rename(name_.c_str(), path.c_str()) == 0;
    exists_ = exists_ && !taken;
    return taken;
}

void sweep_temporary_files(const std::string& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(
        ::opendir(folder.empty() ? "." : folder.c_str()), &::closedir);
    if (!entries) return;
    while (const dirent* const entry = ::readdir(entries.get()))
        if (is_temporary(entry->d_name)) remove_if_nobody_writes(folder + entry->d_name);
}

} // namespace lobelia::host
