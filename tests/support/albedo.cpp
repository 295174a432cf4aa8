#include <algorithm>

#include "support/oracle.h"
#include "support/quadrature.h"

namespace lobelia::oracle {

// In polar coordinates about the mirror direction R, with the normal at the angle b from it, the
// cosine to the normal is cos b cos t + sin b sin t cos(azimuth): its integral over the azimuths
// above the horizon is elementary. Over t, x = cos^(n+1) t makes the lobe's density constant.
double albedo(double cosine, double exponent) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    const double s = std::sqrt((1 - c) * (1 + c));

    const auto over_azimuth = [&](double x, double rest) {
        const double log_x = x < 0.5 ? std::log(x) : std::log1p(-rest);
        const double gap = -std::expm1(log_x / (exponent + 1)); // 1 - cos t
        const double a = c * (1 - gap);
        const double b = s * std::sqrt(gap * (2 - gap));
        if (a >= b) return 2 * PI * a;
        if (a <= -b) return 0.0;
        const double edge = std::acos(-a / b);
        return 2 * (edge * a + b * std::sin(edge));
    };

    // The horizon first touches the lobe at the polar angle pi/2 - b, whose cosine is s.
    const double touch = std::pow(s, exponent + 1);
    const double outer = tanh_sinh(
        [&](double x, double rest) { return over_azimuth(touch * x, 1 - touch + touch * rest); });
    const double inner = tanh_sinh([&](double x, double rest) {
        return over_azimuth(touch + (1 - touch) * x, (1 - touch) * rest);
    });
    return (exponent + 2) / (exponent + 1) / (2 * PI) * (touch * outer + (1 - touch) * inner);
}

} // namespace lobelia::oracle
