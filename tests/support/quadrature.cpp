#include "support/quadrature.h"

#include <array>
#include <cstddef>

namespace lobelia::oracle {
namespace {

// Roots of the Legendre polynomial of degree `points` by Newton's method.
GaussRule make_rule(int points) {
    GaussRule rule;
    for (int i = 0; i < points; ++i) {
        double x = -std::cos(std::acos(-1.0) * (i + 0.75) / (points + 0.5));
        double slope = 1;
        for (int step = 0; step < 8; ++step) {
            double before = 1;
            double value = x;
            for (int k = 2; k <= points; ++k) {
                const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
                before = value;
                value = next;
            }
            slope = points * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        rule.at.push_back(x);
        rule.weight.push_back(2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

} // namespace

const GaussRule& gauss(int points) {
    static const auto rules = [] {
        std::array<GaussRule, MAX_GAUSS_POINTS + 1> all;
        for (int i = 1; i <= MAX_GAUSS_POINTS; ++i) all[std::size_t(i)] = make_rule(i);
        return all;
    }();
    return rules[std::size_t(points)];
}

} // namespace lobelia::oracle
