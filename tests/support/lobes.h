#pragma once

#include <ostream>
#include <vector>

#include <lobelia/lobe.h>

namespace lobelia {

/// For test names and failure messages.
inline void PrintTo(const Lobe& lobe, std::ostream* out) {
    *out << "lobe of kind " << lobe.kind << ", exponent " << lobe.exponent;
}

namespace test {

/// An example or more of each kind, from the widest lobe to the sharpest.
inline std::vector<Lobe> all_lobes() {
    std::vector<Lobe> lobes{lambert()};
    for (float exponent : {0.0f, 1e-30f, 1e-3f, 0.5f, 1.0f, 4.8f, 16.0f, 64.0f, 1e3f, 1e4f, 1e6f})
        lobes.push_back(phong(exponent));
    return lobes;
}

} // namespace test
} // namespace lobelia
