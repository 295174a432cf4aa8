#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/input_file.h"

namespace lobelia::host {

/// Reads a file from its start, one byte after the other, through a small buffer.
class ByteReader {
public:
    explicit ByteReader(const InputFile& file) : file_(file) {}

    /// The next byte, or -1 at the end of the file and on a read error.
    int next() {
        if (next_ == filled_ && !refill()) return -1;
        return int(buffer_[next_++]);
    }

private:
    bool refill() {
        const std::int64_t count = file_.read_at(offset_, buffer_);
        next_ = 0;
        filled_ = count > 0 ? std::size_t(count) : 0;
        offset_ += filled_;
        return filled_ > 0;
    }

    const InputFile& file_;
    std::uint64_t offset_ = 0;
    std::size_t next_ = 0;
    std::size_t filled_ = 0;
    std::array<std::byte, 1 << 16> buffer_;
};

} // namespace lobelia::host
