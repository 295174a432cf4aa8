#pragma once

#include "support/direction.h"

namespace lobelia::oracle {

/// Legendre polynomial of degree l at x.
double legendre(int l, double x);

/// Real spherical harmonic of degree l >= 0 and order m, -l to l, at a direction; orthonormal over
/// the sphere, without the Condon-Shortley sign. The pole is +Y, and m > 0 goes with the cosine of
/// m times the longitude from +Z.
double harmonic(int l, int m, Direction direction);

/// What the lobe average P_n multiplies degree l by (Funk-Hecke), for every real n >= 0:
/// 1, (n + 1) / (n + 2), then lambda_l = lambda_(l-2) (n - l + 2) / (n + l + 1).
double lobe_eigenvalue(double exponent, int l);

} // namespace lobelia::oracle
