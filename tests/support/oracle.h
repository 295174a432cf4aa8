#pragma once

#include <vector>

#include "support/direction.h"
#include "support/source.h"

/// The truth that the library is tested against: the integrals of the lobes over an environment
/// whose texels are patches of constant radiance, in double precision, sharing no text with it.
///
/// Each texel's own integral has a relative error below 1e-7 (1e-9 where no horizon cuts it), so
/// one bright texel in a dark sky is as exact as an even sky; what is left out for being negligible
/// adds below 1e-16 of the environment's mean. Exponents from 0 to 1e6.
namespace lobelia::oracle {

/// How the lobe's weights are made to add up to 1: by the constant of its integral over the sphere,
/// or by their computed sum. The two differ by the quadrature's error alone.
enum class Normalise { analytically, by_weight };

struct Options {
    Normalise normalise = Normalise::analytically;
    int extra_points = 0; // 0 to 2 more points a side in each rule, to see convergence
};

/// P_n: (n + 1) / (2 pi) times the integral of radiance max(0, w . axis)^n. Constant light comes
/// back as it is; n = 1 about a normal is its irradiance / pi. `axis` is a unit vector.
Rgb lobe_average(const Source& source, Direction axis, double exponent, Options options = {});
/// The same for many axes, on two threads.
std::vector<Rgb> lobe_averages(const Source& source, const std::vector<Direction>& axes,
                               double exponent, Options options = {});

/// A normalised Phong material: kd + ks <= 1 in each channel keeps energy.
struct Material {
    Rgb diffuse{};
    Rgb specular{};
    double exponent = 0;
};

/// Radiance towards the unit vector `view` from a surface of unit normal `normal`:
/// kd E(N) / pi + ks (n + 2) / (2 pi) times the integral of radiance max(0, w . R)^n max(0, N . w).
Rgb shade(const Source& source, Direction normal, Direction view, const Material& material,
          Options options = {});

/// The integral in the specular term of `shade`, times (n + 2) / (2 pi): what ks multiplies.
/// `axis` is the mirror direction R. Analytically normalised.
Rgb specular_average(const Source& source, Direction normal, Direction axis, double exponent,
                     Options options = {});

/// Directional albedo W(c, n) of the specular lobe, c = N . R from -1 to 1: what
/// `specular_average` makes of constant light 1. Absolute error below 1e-12.
double albedo(double cosine, double exponent);

} // namespace lobelia::oracle
