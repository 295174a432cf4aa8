#include "host/sanitise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/sizes.h"

#ifdef __FAST_MATH__
#error "-ffast-math removes the tests for NaN and infinity that this file is made of"
#endif

namespace lobelia::host {

namespace {

bool is_finite(const float* texel) {
    return std::isfinite(texel[0]) && std::isfinite(texel[1]) && std::isfinite(texel[2]);
}

template <class Test>
bool any_channel(const float* texel, Test test) {
    return test(texel[0]) || test(texel[1]) || test(texel[2]);
}

void count(const float* texel, Sanitised& counts) {
    if (any_channel(texel, [](float x) { return std::isnan(x); }))
        ++counts.not_a_number;
    else if (any_channel(texel, [](float x) { return std::isinf(x); }))
        ++counts.infinite;
    else if (any_channel(texel, [](float x) { return x < 0.0f; }))
        ++counts.negative;
}

} // namespace

Outcome<Sanitised> sanitise(Image& image) {
    std::array<float, 3> largest{};
    bool any_finite = false;
    for (std::size_t i = 0; i < image.texels.size(); i += CHANNELS) {
        const float* texel = &image.texels[i];
        any_finite = any_finite || is_finite(texel);
        for (std::size_t c = 0; c < 3; ++c)
            if (std::isfinite(texel[c])) largest[c] = std::max(largest[c], texel[c]);
    }
    if (!any_finite) return Failure{"has no finite texel, export it again"};

    Sanitised counts;
    for (std::size_t i = 0; i < image.texels.size(); i += CHANNELS) {
        float* texel = &image.texels[i];
        count(texel, counts);
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = texel[c];
            // A comparison with NaN is false, so NaN, -infinity, negative values and -0 are the
            // else.
            texel[c] = value > 0.0f ? (std::isinf(value) ? largest[c] : value) : 0.0f;
        }
        texel[3] = 1.0f;
    }
    return counts;
}

} // namespace lobelia::host
