#pragma once

#include <chrono>
#include <initializer_list>
#include <list>

#include <lobelia/host/scene_maps.h>

#include "drawing.h"

namespace lobelia::cli {

/// What pictures read of one environment: maps, pass by pass, for each plan that was asked for
/// lately. Maps of several plans are made from the same levels where they can be.
class Lights {
public:
    struct Light {
        host::SceneMaps maps;
        SphereMethod method; // that asked for them
        float exponent;      // likewise
    };

    Lights(host::Gpu& gpu, host::MapPasses& passes, host::GpuEnvironment environment)
        : gpu_(&gpu), passes_(&passes),
          environment_(std::make_unique<host::GpuEnvironment>(std::move(environment))) {}
    const host::GpuEnvironment& environment() const { return *environment_; }
    /// What these settings call for, with levels for edits of an exponent that is `sharpest` now.
    /// Takes milliseconds.
    host::Outcome<ScenePlan> plan(const host::RenderSettings& settings, float sharpest) const;

    /// Goes on until `end`, by a pass at least, towards maps for that plan, and adds what was run
    /// to `work`. What was begun for another plan is ended first, and is what is given then.
    host::Outcome<Light*> advance(const ScenePlan& plan, SphereMethod method, float exponent,
                                  FrameWork& work, std::chrono::steady_clock::time_point end);
    /// Whether this light is all that the plan wants.
    static bool serves(const Light& light, const ScenePlan& plan);
    /// Lets go of the oldest that are not shown.
    void trim(std::initializer_list<const Light*> shown);
    std::uint64_t bytes() const;

private:
    host::Outcome<Light*> begin(const ScenePlan& plan, SphereMethod method, float exponent);

    host::Gpu* gpu_;
    host::MapPasses* passes_;
    std::unique_ptr<host::GpuEnvironment> environment_;
    std::list<Light> lights_; // the latest first
};

} // namespace lobelia::cli
