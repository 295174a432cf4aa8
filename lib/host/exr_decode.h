#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/exr_chunks.h"

namespace lobelia::host {

/// Decodes the chunks of one part, one after the other, into four floats a texel of which the
/// part's colour channels fill the first one or three.
class ExrDecoder {
public:
    ExrDecoder(const ExrCore& core, const ExrPart& part) : core_(core), part_(part) {}
    ~ExrDecoder();
    ExrDecoder(const ExrDecoder&) = delete;
    ExrDecoder& operator=(const ExrDecoder&) = delete;

    /// Texels row by row, valid until the next call. `core`'s budget bounds what this allocates.
    Outcome<std::span<const float>> decode(const ExrChunk& chunk);

private:
    Outcome<Done> decode_by_core(const ExrChunk& chunk);
    Outcome<Done> decode_alone(const ExrChunk& chunk);

    const ExrCore& core_;
    const ExrPart& part_;
    exr_decode_pipeline_t pipeline_ = EXR_DECODE_PIPELINE_INITIALIZER;
    bool started_ = false;
    std::vector<std::byte> packed_;
    std::vector<float> texels_;
};

} // namespace lobelia::host
