#include <lobelia/clipped_tables.h>

#include <bit>
#include <vector>

#include <lobelia/lobe.h>

#include "clipped_lobe.h"
#include "clipped_lobe_table.h"
#include "vk/compute_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr vk::ImageUse FILLED{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

/// The nearest half of a number from 0 to 65504; below 2^-14 it is 0.
std::uint16_t half_of(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    if (value < 6.1035e-5f) return 0;
    return std::uint16_t((bits - 0x38000000u + 0x0fffu + ((bits >> 13) & 1u)) >> 13);
}

/// The largest exponent that a material's taps read, over all angles to the horizon.
double sharpest_tap(Taps taps, double exponent) {
    constexpr int ANGLES = 64;
    double sharpest = exponent + 1;
    for (int i = 0; i <= ANGLES; ++i) {
        // Columns of the table: half of them within four lobe widths of the horizon.
        const double width = 1 / std::sqrt(exponent + 1), column = double(i) / ANGLES;
        const double height = 2 * width * column / (1 + 2 * width - column);
        const double cosine = 1 - (1 - height) * (1 - height);
        const MatchedTaps matched = matched_taps(cosine, exponent);
        sharpest =
            std::max(sharpest, taps == Taps::one   ? matched.one_tap_exponent
                               : taps == Taps::two ? matched.two_tap_exponent
                                                   : horizon_pair(cosine, exponent).exponent);
    }
    if (taps != Taps::five) return sharpest;
    return std::max(sharpest, 1 / double(horizon_taps(0.5f, float(exponent)).middle_variance));
}

} // namespace

Ladder ladder_for(Taps taps, float least, float most) {
    const double lowest = double(least) + 1;
    const double steps = 2 * std::log2(sharpest_tap(taps, double(most)) / lowest);
    return {float(lowest), std::max(std::uint32_t(std::ceil(steps - 1e-3)) + 1, 2u)};
}

struct ClippedTables::State {
    vk::Context context;
    std::vector<std::uint16_t> halves;
};

Result<ClippedTables> ClippedTables::create(const Device& device) {
    return vk::guarded<ClippedTables>([&] {
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        for (const auto& table : {make_clipped_table(), make_horizon_table()})
            for (const ClippedTexel& texel : table)
                for (const float value : texel) state->halves.push_back(half_of(value));
        return ClippedTables(std::move(state));
    });
}

void ClippedTables::record(VkCommandBuffer commands, VkBuffer buffer,
                           VkImage image) const noexcept {
    const vk::Context& context = state_->context;
    const vk::Label label(context, commands, "lobelia clipped tables");
    // What was recorded before may still read or write the buffer.
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_WRITE_BIT);
    context.call.vkCmdUpdateBuffer(commands, buffer, 0, BUFFER_BYTES, state_->halves.data());
    vk::memory_barrier(context, commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                       VK_ACCESS_TRANSFER_READ_BIT);
    vk::image_barrier(context, commands, image, vk::DISCARDED, FILLED);
    const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, LAYERS},
                                   .imageExtent = {WIDTH, HEIGHT, 1}};
    context.call.vkCmdCopyBufferToImage(commands, buffer, image,
                                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    vk::image_barrier(context, commands, image, FILLED, vk::SAMPLED);
}

static_assert(ClippedTables::WIDTH == CLIPPED_TABLE_WIDTH);
static_assert(ClippedTables::HEIGHT == CLIPPED_TABLE_HEIGHT);

} // namespace lobelia
