// Where to read blurred maps for a specular lobe that the horizon cuts, for C++ and GLSL alike. The
// numbers come from a small table (lib/clipped_lobe_table.h fills it) that a shader reads bilinearly:
//     ClippedTablePoint at = clipped_table_point(cos_theta, exponent);
//     vec4 texel = textureLod(table, vec2(at.u, at.v), 0.0);
//     ClippedTaps taps = clipped_taps(texel.x, texel.y, texel.z, texel.w, cos_theta, exponent);
// N is the normal, R the mirror direction, cos_theta = N.R in [0, 1], n the exponent.
#ifndef LOBELIA_CLIPPED_LOBE_GLSL
#define LOBELIA_CLIPPED_LOBE_GLSL

#include "lobelia/language.glsl"

const uint CLIPPED_TABLE_WIDTH = 32u;
const uint CLIPPED_TABLE_HEIGHT = 16u;

// Texture coordinates, for a sampler that clamps to the edge.
struct ClippedTablePoint {
    float u;
    float v;
};

// Rows are equally spaced in 1 / sqrt(n + 1), the lobe's width: 1 for n = 0, and 0 for the limit
// of sharp lobes, which a shader may take n = 1e6 for. Columns are a ratio of 1 - sqrt(1 - cos_theta),
// smooth up to cos_theta = 1, that has half of them within four widths of the horizon.
SHARED ClippedTablePoint clipped_table_point(float cos_theta, float exponent) {
    float width = 1.0f / sqrt(exponent + 1.0f);
    float height = 1.0f - sqrt(max(1.0f - cos_theta, 0.0f));
    float column = height * (1.0f + 2.0f * width) / (height + 2.0f * width);
    ClippedTablePoint at;
    at.u = (column * float(CLIPPED_TABLE_WIDTH - 1u) + 0.5f) / float(CLIPPED_TABLE_WIDTH);
    at.v = (width * float(CLIPPED_TABLE_HEIGHT - 1u) + 0.5f) / float(CLIPPED_TABLE_HEIGHT);
    return at;
}

// The lobe's average is albedo W times
//     one tap:  P(axis) with exponent 1 / one_tap_variance, or
//     two taps: the mean of P(axis + across N x R) and P(axis - across N x R) with exponent
//               1 / two_tap_variance,
// where axis = N + along_mirror R, of any length. Maps of several exponents are best mixed linearly
// in 1 / exponent, so that is what is here.
struct ClippedTaps {
    float along_mirror;
    float one_tap_variance;
    float two_tap_variance;
    float across;
};

SHARED ClippedTaps clipped_taps(float shift, float one_tap, float two_tap, float offset,
                                float cos_theta, float exponent) {
    float width = 1.0f / sqrt(exponent + 1.0f);
    float k = exponent * cos_theta + shift / width;
    ClippedTaps taps;
    taps.along_mirror = k;
    taps.one_tap_variance = one_tap * width * width;
    taps.two_tap_variance = two_tap * width * width;
    taps.across = offset * width * sqrt(1.0f + k * (2.0f * cos_theta + k));
    return taps;
}

// Nearer to the truth: a pair of lobes that reaches below the horizon, less three sharper ones that
// stand along it. The lobe's average is W times
//     (1 + weight) times the mean of P(axis + across N x R) and P(axis - across N x R), minus
//     weight times (3/8 P(middle) + 5/16 P(middle + side N x R) + 5/16 P(middle - side N x R)),
// and at least 0. The pair comes from clipped_taps() with a texel of the horizon's own table, whose
// second number is the weight: below a half, and 0 (two fetches are enough) from five lobe widths
// above the horizon on.
struct HorizonTaps {
    float along_mirror; // middle = along_mirror R + along_normal N, of any length
    float along_normal;
    float side;
    float middle_variance; // 1 / exponent
    float side_variance;
};

const float HORIZON_MIDDLE_SHARE = 0.375f;

// The numbers are those of least error for sharp lobes in light of the spectrum of photographs, whose
// power falls with the square of the frequency. Broad lobes want sharper taps of less weight.
SHARED float horizon_sharpness(float exponent) {
    return exponent * exponent / (exponent * exponent + 8.0f);
}

SHARED HorizonTaps horizon_taps(float cos_theta, float exponent) {
    float width = 1.0f / sqrt(exponent + 1.0f);
    // Never 0, so that the taps have a direction even at the pole, where they have no weight.
    float sine = sqrt(max((1.0f - cos_theta) * (1.0f + cos_theta), 1e-6f));
    // In lobe widths from R, with x for the height above the horizon, (0.0374 + 0.8737 x) /
    // (1 + 0.1595 x) towards it.
    float rise = sine * width;
    float down = width * (0.0374f * rise + 0.8737f * cos_theta) / (rise + 0.1595f * cos_theta);
    float sharp = max(horizon_sharpness(exponent), 0.1f);
    HorizonTaps taps;
    taps.along_mirror = sine + down * cos_theta;
    taps.along_normal = -down;
    taps.side = width;
    taps.middle_variance = 0.25f * sharp * width * width;
    taps.side_variance = 0.35355f * sharp * width * width;
    return taps;
}

#endif
