#pragma once

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <lobelia/host/gpu.h>

namespace lobelia::test {

/// A test on the GPU. It fails on any validation message, even when its own checks pass.
class GpuTest : public testing::Test {
protected:
    host::Gpu& gpu = shared_gpu();

    void TearDown() override {
        for (const std::string& message : gpu.take_messages()) ADD_FAILURE() << message;
    }

private:
    // One for a whole program: a device costs more than most tests.
    static host::Gpu& shared_gpu() {
        static host::Gpu one = [] {
            auto created = host::Gpu::create({.validation = true});
            if (!created) throw std::runtime_error(created.error().message);
            return *std::move(created);
        }();
        return one;
    }
};

} // namespace lobelia::test
