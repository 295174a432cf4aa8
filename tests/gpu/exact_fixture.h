#pragma once

#include <cmath>

#include "support/exact_averages.h"
#include "support/gpu_test.h"

namespace lobelia::test {

inline oracle::Rgb grey(double value) {
    return {value, value, value};
}

/// Asks the exact integration for averages and hands them back.
class ExactTest : public GpuTest {
protected:
    using Directions = std::vector<oracle::Direction>;

    Exact exact = value_of(Exact::create(gpu.device()));

    std::vector<Average> ask(const host::GpuImage& source, const ExactSettings& settings,
                             const std::vector<ExactQuery>& queries,
                             const std::vector<std::uint32_t>& split = {}) {
        Asked asked = test::ask(gpu, exact, source, settings, queries, split);
        steps = asked.steps;
        return std::move(asked.averages);
    }
    std::vector<Average> averages(const host::GpuImage& source, float exponent,
                                  const Directions& axes) {
        return ask(source, {.exponent = exponent}, unclipped(axes));
    }
    std::vector<Average> averages(const oracle::Source& source, float exponent,
                                  const Directions& axes) {
        return averages(on_device(gpu, image_of(source)), exponent, axes);
    }

    /// What the last question was split into.
    std::uint32_t steps = 0;
};

} // namespace lobelia::test
