#include "host/resize.h"

#include <algorithm>
#include <cmath>

namespace lobelia::host {

namespace {

/// Part of a texel's span that lies in one texel of the source.
struct Overlap {
    std::uint32_t index;
    double middle; // face coordinate from -1 to 1
    double length; // in face coordinates
};

std::vector<Overlap> overlaps(std::uint32_t texel, std::uint32_t size, std::uint32_t source_size) {
    std::vector<Overlap> parts;
    const double low = 2.0 * texel / size - 1, high = 2.0 * (texel + 1) / size - 1;
    const auto first = std::uint32_t(std::uint64_t(texel) * source_size / size);
    for (std::uint32_t i = first; i < source_size; ++i) {
        const double from = std::max(low, 2.0 * i / source_size - 1);
        const double to = std::min(high, 2.0 * (i + 1) / source_size - 1);
        if (from >= high) break;
        if (to > from) parts.push_back({i, (from + to) / 2, to - from});
    }
    return parts;
}

} // namespace

Image resize_faces(const Image& cube, std::uint32_t size) {
    Image result{Layout::cube, size, size, 6, std::vector<float>(std::size_t(24) * size * size)};
    std::vector<std::vector<Overlap>> spans;
    for (std::uint32_t i = 0; i < size; ++i) spans.push_back(overlaps(i, size, cube.width));
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                double sum[3] = {}, weights = 0;
                for (const Overlap& down : spans[y])
                    for (const Overlap& across : spans[x]) {
                        const double square =
                            1 + across.middle * across.middle + down.middle * down.middle;
                        const double weight = across.length * down.length * std::pow(square, -1.5);
                        const float* const from = cube.texel(face, across.index, down.index);
                        for (int channel = 0; channel < 3; ++channel)
                            sum[channel] += weight * double(from[channel]);
                        weights += weight;
                    }
                float* const to = result.texel(face, x, y);
                for (int channel = 0; channel < 3; ++channel)
                    to[channel] = float(sum[channel] / weights);
                to[3] = 1.0f;
            }
    return result;
}

} // namespace lobelia::host
