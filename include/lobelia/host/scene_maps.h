#pragma once

#include <memory>

#include <lobelia/host/work.h>
#include <lobelia/scene.h>

namespace lobelia::host {

/// Whether the sphere may cover some of the picture. False only where it certainly does not.
bool sees_sphere(const SphereView& view);

/// What render() records for valid settings once an environment with faces of `face` texels is on
/// the device; `constant` where all its texels are known to be equal, `levels_up_to` as in Scene.
Outcome<ScenePlan> plan_scene(const Gpu& gpu, std::uint32_t face, bool constant,
                              const RenderSettings& settings, float levels_up_to = 0.0f);

/// What makes maps, for all environments of one device: each pass is compiled when a plan first has
/// it, and the tables that all share are made once.
class MapPasses {
public:
    explicit MapPasses(Gpu& gpu); // which outlives this
    MapPasses(MapPasses&&) noexcept;
    MapPasses& operator=(MapPasses&&) noexcept;
    ~MapPasses();

    struct State;
    State& state() const { return *state_; }

private:
    std::unique_ptr<State> state_;
};

/// Carries out a ScenePlan but for its draw: everything that the sphere pass reads of one
/// environment, made pass by pass. What SphereMethod::reference integrates is not among it.
class SceneMaps {
public:
    /// Makes images, buffers and descriptors; nothing runs yet. All arguments but the plan outlive
    /// this. From `before`, maps of the same source, come the levels where the plans share them
    /// and its passes have made them: only passes that make maps are left then.
    static Outcome<SceneMaps> create(MapPasses& passes, const GpuEnvironment& environment,
                                     const ScenePlan& plan, const SceneMaps* before = nullptr);
    SceneMaps(SceneMaps&&) noexcept;
    SceneMaps& operator=(SceneMaps&&) noexcept;
    ~SceneMaps();

    const ScenePlan& plan() const;
    std::size_t pass_count() const;
    std::size_t passes_left() const;
    /// Runs the next pass and waits for it.
    Outcome<PassReport> run_pass();

    // What follows holds once no pass is left.

    const SphereSources& sources() const;
    /// Of a plan whose maps these are (SceneEdit::Maps::kept): its own, without suns where none
    /// were found.
    SphereShading shading(const ScenePlan& plan) const;
    /// Suns that were taken out of the maps; nothing where there was no prefilter.
    std::optional<std::uint32_t> suns() const;

private:
    struct State;
    explicit SceneMaps(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace lobelia::host
