#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <sys/stat.h>

#include <lobelia/host/outcome.h>

#include "host/descriptor.h"

namespace lobelia::host {

/// A regular file, open for reading at any offset. Nothing else is opened: a FIFO would block, a
/// device may never end. It is read rather than mapped, so that a file that shrinks meanwhile is an
/// error and not a signal.
class InputFile {
public:
    /// Fails when `path` cannot be opened, is not a regular file, is empty, or holds more than
    /// `limit` bytes. The message does not name the path.
    static Outcome<InputFile> open(const std::string& path, std::uint64_t limit);

    std::uint64_t size() const { return std::uint64_t(state_.st_size); }

    /// Fills `into` from `offset` and returns how many bytes there were: fewer only at the end of
    /// the file, -1 on a read error.
    std::int64_t read_at(std::uint64_t offset, std::span<std::byte> into) const;

    /// Whether the file is still as it was when opened, by its size and time of modification.
    bool unchanged() const;

private:
    InputFile(Descriptor descriptor, const struct stat& state)
        : descriptor_(std::move(descriptor)), state_(state) {}

    Descriptor descriptor_;
    struct stat state_;
};

} // namespace lobelia::host
