#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <lobelia/host/write.h>

#include "support/run_program.h"

// Every call that writes a file, failing in every way: the old file or the new one, whole, and
// nothing beside it. The linker puts these functions in the place of the system's (--wrap).
namespace {

enum class Kind { open, write, read, sync, close, rename };

struct IoFault {
    std::size_t call = 0;
    int code = 0; // errno; 0: less is done than was asked for
    bool sticky = false;
};
std::optional<IoFault> fault;
std::vector<Kind> calls;
bool watching = false;

/// Whether this call is to fail.
bool fails(Kind kind) {
    if (!watching) return false;
    calls.push_back(kind);
    const std::size_t index = calls.size() - 1;
    return fault && (index == fault->call ||
                     (fault->sticky && index > fault->call && kind == calls[fault->call]));
}

int failed() {
    errno = fault->code;
    return -1;
}

} // namespace

extern "C" {
int __real_open(const char*, int, ...);
ssize_t __real_write(int, const void*, std::size_t);
ssize_t __real_pread(int, void*, std::size_t, off_t);
int __real_fsync(int);
int __real_close(int);
int __real_rename(const char*, const char*);

int __wrap_open(const char* path, int flags, ...) {
    std::va_list rest;
    va_start(rest, flags);
    const unsigned mode = flags & O_CREAT ? va_arg(rest, unsigned) : 0;
    va_end(rest);
    if (flags & O_CREAT && fails(Kind::open) && fault->code) return failed();
    return __real_open(path, flags, mode);
}
ssize_t __wrap_write(int file, const void* bytes, std::size_t size) {
    if (!fails(Kind::write)) return __real_write(file, bytes, size);
    return fault->code ? failed() : __real_write(file, bytes, (size + 1) / 2);
}
ssize_t __wrap_pread(int file, void* bytes, std::size_t size, off_t offset) {
    if (!fails(Kind::read)) return __real_pread(file, bytes, size, offset);
    return fault->code ? failed() : __real_pread(file, bytes, (size + 1) / 2, offset);
}
int __wrap_fsync(int file) {
    return fails(Kind::sync) && fault->code ? failed() : __real_fsync(file);
}
int __wrap_close(int file) {
    const bool failing = fails(Kind::close) && fault->code;
    const int closed = __real_close(file); // it is closed, whatever is said
    return failing ? failed() : closed;
}
int __wrap_rename(const char* from, const char* to) {
    return fails(Kind::rename) && fault->code ? failed() : __real_rename(from, to);
}
}

namespace lobelia::test {
namespace {

struct Writer {
    const char* name;
    std::function<host::Outcome<Done>(const std::string& path)> write;
};

std::vector<Writer> writers() {
    static const host::Image picture{host::Layout::latlong, 64, 32, 1,
                                     std::vector<float>(64 * 32 * 4, 0.5f)};
    static const host::Image cube{host::Layout::cube, 8, 8, 6,
                                  std::vector<float>(6 * 64 * 4, 0.5f)};
    return {{"exr",
             [](const std::string& path) {
                 const host::Part part{"", &picture};
                 return host::write_exr(path, {&part, 1}, host::Content::environment);
             }},
            {"png", [](const std::string& path) { return host::write_png(path, picture, 0.0f); }},
            {"ktx2", [](const std::string& path) {
                 return host::write_ktx2(path, {&cube, 1});
             }}};
}

host::Outcome<Done> watched(const Writer& writer, const std::string& path,
                            std::optional<IoFault> with) {
    fault = with;
    calls.clear();
    watching = true;
    auto written = writer.write(path);
    watching = false;
    return written;
}

// What may be done again is; what only hastens the new name's way to the disk may fail.
bool may_succeed(const IoFault& injected, Kind kind, bool before_rename) {
    const bool repeats = kind == Kind::write || kind == Kind::read;
    return injected.code == 0 || (repeats && injected.code == EINTR) || !before_rename;
}

TEST(IoFaults, LeaveTheOldFileOrTheNewOne) {
    int injected = 0;
    for (const Writer& writer : writers()) {
        const TemporaryFolder folder;
        const std::string path = folder / "file";
        ASSERT_TRUE(watched(writer, path, {}));
        const std::vector<Kind> all = calls;
        const std::string complete = read_bytes(path);
        const auto renamed = std::find(all.begin(), all.end(), Kind::rename) - all.begin();
        ASSERT_LT(std::size_t(renamed), all.size());
        for (std::size_t call = 0; call < all.size(); ++call)
            for (const int code : {ENOSPC, EIO, EINTR, EDQUOT, 0})
                for (const bool sticky : {false, true}) {
                    if (sticky && code == EINTR) continue; // no signal arrives for ever
                    const IoFault with{call, code, sticky};
                    SCOPED_TRACE(std::string(writer.name) + ", call " + std::to_string(call) +
                                 ", errno " + std::to_string(code));
                    write_bytes(path, "old");
                    const auto written = watched(writer, path, with);
                    ++injected;
                    EXPECT_EQ(read_bytes(path), written ? complete : "old");
                    EXPECT_EQ(bool(written),
                              may_succeed(with, all[call], std::ptrdiff_t(call) <= renamed));
                    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
                    EXPECT_TRUE(written || written.error().message.starts_with(path + ": "));
                }
    }
    RecordProperty("faults", injected);
}

} // namespace
} // namespace lobelia::test
