#include <cmath>

#include <lobelia/host/work.h>

#include "host/checks.h"
#include "host/text.h"

namespace lobelia::host {

namespace {

constexpr const char* CHANNEL_NAMES[] = {"red", "green", "blue"};
constexpr float LARGEST_EXPONENT = 1e6f;
constexpr double SLACK = 1e-6; // of kd + ks, for sums that are 1 but for their rounding

std::optional<Failure> check_reflectance(const char* name, const std::array<float, 3>& values) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!std::isfinite(values[i]) || values[i] < 0.0f)
            return Failure{std::string(name) + " is " + number_text(values[i]) + " in the " +
                           CHANNEL_NAMES[i] + " channel, give a number from 0 to 1"};
    return std::nullopt;
}

std::optional<Failure> check_energy(const Material& material) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double sum = double(material.diffuse[i]) + double(material.specular[i]);
        if (sum > 1.0 + SLACK)
            return Failure{"kd + ks is " + number_text(material.diffuse[i]) + " + " +
                           number_text(material.specular[i]) + " = " + number_text(float(sum)) +
                           " in the " + CHANNEL_NAMES[i] +
                           " channel, more light than comes in: lower one of them, or pass "
                           "--allow-energy-gain"};
    }
    return std::nullopt;
}

} // namespace

std::optional<Failure> check_exponent(float exponent) {
    if (exponent >= 0.0f && exponent <= LARGEST_EXPONENT) return std::nullopt;
    return Failure{"the exponent n is " + number_text(exponent) +
                   ", give a number from 0 to 1000000"};
}

std::optional<Failure> check_material(const Material& material, bool allow_energy_gain) {
    if (auto refused = check_reflectance("kd", material.diffuse)) return refused;
    if (auto refused = check_reflectance("ks", material.specular)) return refused;
    if (auto refused = check_exponent(material.exponent)) return refused;
    return allow_energy_gain ? std::nullopt : check_energy(material);
}

} // namespace lobelia::host
