#pragma once

#include <cstdint>

namespace lobelia::host {

inline constexpr std::uint32_t FACES = 6;    // of a cube
inline constexpr std::uint32_t CHANNELS = 4; // of a texel in memory: R G B A, each a float
inline constexpr std::uint64_t TEXEL_BYTES = CHANNELS * sizeof(float);

inline constexpr std::uint64_t cube_texels(std::uint64_t size) {
    return FACES * size * size;
}

} // namespace lobelia::host
