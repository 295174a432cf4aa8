#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lobelia::test {

/// A KTX 2.0 file taken apart by the offsets that it gives, with no other knowledge of how it was
/// written. Reading beyond the end throws std::out_of_range.
class Ktx2File {
public:
    struct Level {
        std::uint64_t offset, size, uncompressed_size;
    };

    explicit Ktx2File(std::string bytes);

    std::string identifier;
    std::uint32_t format, type_size, width, height, depth, layers, faces, level_count, compression;
    std::uint32_t descriptor_offset, descriptor_size, keys_offset, keys_size;
    std::uint64_t global_offset, global_size;
    std::vector<Level> levels;
    std::vector<std::uint32_t> descriptor;                 // its words, the size first
    std::vector<std::pair<std::string, std::string>> keys; // values with all their bytes
    std::string padding;                                   // every byte between two parts

    std::uint64_t size() const { return bytes_.size(); }
    const std::string& value_of(const std::string& key) const;

    /// A channel of a texel of four floats of `type_size` bytes.
    float channel(std::uint32_t level, std::uint32_t face, std::uint32_t x, std::uint32_t y,
                  std::uint32_t channel) const;

private:
    std::uint64_t number(std::uint64_t offset, unsigned size) const;
    void read_keys();
    void read_padding();

    std::string bytes_;
};

} // namespace lobelia::test
