#pragma once

#include <cmath>

#include "support/direction.h"

namespace lobelia::oracle {

/// max(0, c)^n for c above 0; the caller keeps what lies below the horizon out.
struct Power {
    explicit Power(double exponent)
        : n(exponent),
          whole(exponent == std::floor(exponent) && exponent <= 4096 ? int(exponent) : -1),
          root_like(whole < 0 && exponent < 16) {
        if (root_like && n < 4) straightening = n >= 2 ? 2 : n >= 1 ? 3 : 4;
    }

    double operator()(double c) const {
        if (whole < 0) return std::pow(c, n);
        double result = 1;
        for (int bits = whole; bits; bits >>= 1, c *= c)
            if (bits & 1) result *= c;
        return result;
    }

    double n;
    int whole;             // n where that is a small whole number, else -1
    bool root_like;        // near c = 0 no polynomial follows c^n
    int straightening = 1; // p: c^n is smooth in t where c = t^p
};

/// What is integrated over the sphere: max(0, w . axis)^n, times max(0, w . normal) if `clamped`.
struct Weight {
    Direction axis;
    Power power;
    bool clamped = false;
    Direction normal{};
};

} // namespace lobelia::oracle
