#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfIO.h>

namespace lobelia::host {

/// Lets OpenEXR's C++ readers read from memory.
class MemoryIStream : public Imf::IStream {
public:
    explicit MemoryIStream(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}

    bool read(char into[], int count) override {
        if (count < 0 || std::size_t(count) > bytes_.size() - position_)
            throw Iex::InputExc("unexpected end of data");
        std::memcpy(into, bytes_.data() + position_, std::size_t(count));
        position_ += std::size_t(count);
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size()) throw Iex::InputExc("position beyond the end of data");
        position_ = position;
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

/// Lets OpenEXR's C++ writers write to memory.
class MemoryOStream : public Imf::OStream {
public:
    MemoryOStream() : OStream("memory") {}

    void write(const char from[], int count) override {
        const std::size_t end = position_ + std::size_t(count);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, from, std::size_t(count));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

} // namespace lobelia::host
