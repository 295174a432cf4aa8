#include "findings.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace lobelia::hard {

void Findings::at(const std::string& where) {
    where_ = where;
    ++points_;
}

void Findings::within(double error, double allowed) {
    ++others_;
    EXPECT_LE(error, allowed) << place();
    // A first error of 0 is kept too, so that what is allowed is told.
    if (allowed_ == 0 || !(error * allowed_ <= worst_ * allowed)) {
        worst_ = error;
        allowed_ = allowed;
    }
}

void Findings::near(double found, double truth, double allowed) {
    within(std::abs(found / truth - 1), allowed);
}

void Findings::holds(bool fact, const std::string& what) {
    ++others_;
    EXPECT_TRUE(fact) << place() << what;
}

void Findings::refused(const std::string& message, const std::string& words) {
    ++refusals_;
    EXPECT_NE(message, "") << place() << "accepted";
    EXPECT_NE(message.find(words), std::string::npos) << place() << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << place() << message;
}

void Findings::sound(std::span<const float> values) {
    ++others_;
    texels += values.size();
    const auto bad = std::count_if(values.begin(), values.end(), [](float value) {
        return !std::isfinite(value) || value < 0.0f;
    });
    non_finite += std::uint64_t(bad);
    EXPECT_EQ(bad, 0) << place() << "values that are no radiance";
}

void Findings::exact(double found, double truth, double brightest, double exponent,
                     double allowed) {
    const double error = std::abs(found - truth) / std::max(truth, 1e-6 * brightest);
    double& worst = exponent <= 1e4 ? worst_exact : worst_sharp;
    worst = std::max(worst, error);
    within(error, std::min(allowed, exponent <= 1e4 ? 1e-4 : 1e-3));
}

} // namespace lobelia::hard
