#include "clipped_lobe_table.h"

#include <cmath>

#include "clipped_lobe.h"

namespace lobelia {
namespace {

constexpr double LARGEST_EXPONENT = 1e6;

/// Where a texel of the table stands.
struct Place {
    double exponent;
    double cosine;
    double sine;
};

// The inverse of clipped_table_point(); the row of width 0 holds the sharpest lobe.
Place place_of(double column, double row_width) {
    Place place{};
    place.exponent = row_width > 0 ? 1 / (row_width * row_width) - 1 : LARGEST_EXPONENT;
    const double width = 1 / std::sqrt(place.exponent + 1);
    const double height = 2 * width * column / (1 + 2 * width - column);
    place.cosine = 1 - (1 - height) * (1 - height);
    place.sine = std::sqrt((1 - place.cosine) * (1 + place.cosine));
    return place;
}

float stored_shift(const Place& at, double shift) {
    const double along_mirror = at.sine / std::tan(shift) - at.cosine;
    return float((along_mirror - at.exponent * at.cosine) / std::sqrt(at.exponent + 1));
}
float stored_variance(const Place& at, double exponent) {
    return float((at.exponent + 1) / exponent);
}
float stored_offset(const Place& at, double angle) {
    return float(std::tan(angle) * std::sqrt(at.exponent + 1) / at.sine);
}

template <class MakeTexel>
std::vector<ClippedTexel> make_table(ClippedTexel pole, MakeTexel make_texel) {
    std::vector<ClippedTexel> table;
    for (uint row = 0; row < CLIPPED_TABLE_HEIGHT; ++row) {
        const double width = double(row) / (CLIPPED_TABLE_HEIGHT - 1);
        for (uint column = 0; column + 1 < CLIPPED_TABLE_WIDTH; ++column)
            table.push_back(
                make_texel(place_of(double(column) / (CLIPPED_TABLE_WIDTH - 1), width)));
        // At the pole two taps are one, and the offset is that of a lobe nearby: with an exponent
        // next to 0 it tends so slowly to its limit that the limit would mislead.
        pole[3] = make_texel(place_of(1 - 1.0 / (4 * CLIPPED_TABLE_WIDTH), width))[3];
        table.push_back(pole);
    }
    return table;
}

} // namespace

std::vector<ClippedTexel> make_clipped_table() {
    return make_table({0, 1, 1, 0}, [](const Place& at) -> ClippedTexel {
        const MatchedTaps taps = matched_taps(at.cosine, at.exponent);
        return {stored_shift(at, taps.shift), stored_variance(at, taps.one_tap_exponent),
                stored_variance(at, taps.two_tap_exponent), stored_offset(at, taps.two_tap_angle)};
    });
}

std::vector<ClippedTexel> make_horizon_table() {
    return make_table({0, 0, 1, 0}, [](const Place& at) -> ClippedTexel {
        const HorizonPair pair = horizon_pair(at.cosine, at.exponent);
        return {stored_shift(at, pair.shift), float(pair.weight),
                stored_variance(at, pair.exponent), stored_offset(at, pair.angle)};
    });
}

} // namespace lobelia
