// How much light a surface's specular lobe gives back, for C++ and GLSL alike. docs/albedo.md
// derives the formulas.
#ifndef LOBELIA_ALBEDO_GLSL
#define LOBELIA_ALBEDO_GLSL

#include "lobelia/lobe.glsl"

// Directional albedo of the normalised Phong lobe: the share W of a uniform environment that it
// reflects where `cos_theta` is the cosine from the normal N to the mirror direction R,
//     W = (n + 2) / (2 pi) times the integral of (w.R)^n (N.w) over w.R > 0 and N.w > 0.
// The absolute error is below 1e-6 for every exponent n from 0 to 1e6. W is 1 for cos_theta = 1 and
// rises with cos_theta; a cosine outside [0, 1] counts as the nearer end.
//
// W = c + D, where D is what the horizon does: an incomplete beta function. A recurrence takes D
// to the exponent m = n + 4, which leaves small exponents exact; there D is sin^m times
// z / (1 + x + ...), x = c / (2 W(0, m)), with seven fitted numbers.
SHARED float phong_albedo(float cos_theta, float exponent) {
    float n = exponent;
    float c = min(max(cos_theta, 0.0f), 1.0f);
    float z = (1.0f - c) * (1.0f + c);

    // b = sqrt(pi) Gamma(m/2 + 1) / Gamma(m/2 + 1/2) = 1 / (2 W(0, m)), within 1e-7 of itself
    float y = 0.5f * n + 2.25f;
    float h = 1.0f / y;
    float b = sqrt(PI * (y + h * (0.03125f - h * h * (0.00436479f - 0.00181656f * h * h))));

    float x = b * c;
    float w = x / (1.0f + 0.028f * x); // keeps the polynomial bounded where sin^m is 0 anyway
    float bend = -0.245506f + w * (0.031798f - 0.001431f * w) +
                 h * (-0.317942f - 0.102734f * w + h * (0.043543f + 0.037379f * w));
    float mills = z / (1.0f + w + w * w * bend + (n + 5.0f) * c * c);

    float recurrence = n + 4.0f + (n + 1.0f) * z * (1.0f + (n + 3.0f) * mills);
    float scale = 2.0f * (n + 1.0f) * (n + 3.0f) * b;
    return c + chord_power(c * c, 0.5f * n) * z * recurrence / scale;
}

#endif
