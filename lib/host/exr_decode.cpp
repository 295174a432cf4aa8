#include "host/exr_decode.h"

#include <string>

#include "host/exr_dwa.h"
#include "host/exr_single_chunk.h"

namespace lobelia::host {

ExrDecoder::~ExrDecoder() {
    if (started_) exr_decoding_destroy(core_.context(), &pipeline_);
}

Outcome<std::span<const float>> ExrDecoder::decode(const ExrChunk& chunk) {
    texels_.resize(std::size_t(chunk.info.width) * std::size_t(chunk.info.height) * 4);
    const Outcome<Done> decoded = part_.by_core() ? decode_by_core(chunk) : decode_alone(chunk);
    if (!decoded)
        return Failure{"is damaged near texel (" + std::to_string(chunk.x) + ", " +
                       std::to_string(chunk.y) + ")" + decoded.error().message +
                       ", export it again"};
    return std::span<const float>(texels_);
}

Outcome<Done> ExrDecoder::decode_by_core(const ExrChunk& chunk) {
    const auto failure = [&] { return Failure{core_.reason()}; };
    const exr_result_t ready =
        started_ ? exr_decoding_update(core_.context(), part_.index, &chunk.info, &pipeline_)
                 : exr_decoding_initialize(core_.context(), part_.index, &chunk.info, &pipeline_);
    if (ready != EXR_ERR_SUCCESS) return failure();
    if (std::size_t(pipeline_.channel_count) != part_.channels.size()) return failure();

    for (std::size_t c = 0; c < part_.colour.size(); ++c) {
        exr_coding_channel_info_t& channel = pipeline_.channels[part_.colour[c]];
        channel.decode_to_ptr = reinterpret_cast<std::uint8_t*>(texels_.data() + c);
        channel.user_data_type = EXR_PIXEL_FLOAT;
        channel.user_bytes_per_element = sizeof(float);
        channel.user_pixel_stride = 4 * sizeof(float);
        channel.user_line_stride = chunk.info.width * channel.user_pixel_stride;
    }
    if (!started_ && exr_decoding_choose_default_routines(core_.context(), part_.index,
                                                          &pipeline_) != EXR_ERR_SUCCESS)
        return failure();
    started_ = true;
    if (exr_decoding_run(core_.context(), part_.index, &pipeline_) != EXR_ERR_SUCCESS)
        return failure();
    return Done{};
}

Outcome<Done> ExrDecoder::decode_alone(const ExrChunk& chunk) {
    packed_.resize(chunk.info.packed_size);
    if (exr_read_chunk(core_.context(), part_.index, &chunk.info, packed_.data()) !=
        EXR_ERR_SUCCESS)
        return Failure{core_.reason()};
    if (part_.dwa() && packed_.size() != chunk.info.unpacked_size &&
        !is_plausible_dwa(part_, chunk.info, packed_))
        return Failure{" (its figures do not add up)"};
    return decode_single_chunk(part_, chunk, packed_, texels_);
}

} // namespace lobelia::host
