#include "lights.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr std::size_t MOST_LIGHTS = 6;   // kept for going back to
constexpr float EDITED_UP_TO = 10000.0f; // exponents on the panel's slider
constexpr float SHARPER_TAPS = 4.05f;    // than n + 1: Taps::five reads up to 4 times that

} // namespace

Outcome<ScenePlan> Lights::plan(const host::RenderSettings& settings, float sharpest) const {
    return host::plan_scene(*gpu_, environment_->cube.description().width, environment_->constant,
                            settings, SHARPER_TAPS * (std::max(sharpest, EDITED_UP_TO) + 1.0f));
}

bool Lights::serves(const Light& light, const ScenePlan& plan) {
    return edit_between(light.maps.plan(), plan).maps == SceneEdit::Maps::kept;
}

Outcome<Lights::Light*> Lights::begin(const ScenePlan& plan, SphereMethod method, float exponent) {
    const auto source = std::find_if(lights_.begin(), lights_.end(), [&](const Light& light) {
        const PrefilterPlan* const made = light.maps.plan().prefilter();
        return made && plan.prefilter() && plan.prefilter()->shares_levels(*made);
    });
    auto maps = host::SceneMaps::create(*passes_, *environment_, plan,
                                        source == lights_.end() ? nullptr : &source->maps);
    if (!maps) return maps.error();
    lights_.push_front({std::move(*maps), method, exponent});
    return &lights_.front();
}

Outcome<Lights::Light*> Lights::advance(const ScenePlan& plan, SphereMethod method, float exponent,
                                        FrameWork& work,
                                        std::chrono::steady_clock::time_point end) {
    const auto find = [&](auto wanted) {
        return std::find_if(lights_.begin(), lights_.end(), wanted);
    };
    auto found =
        find([&](const Light& light) { return !light.maps.passes_left() && serves(light, plan); });
    if (found == lights_.end())
        found = find([](const Light& light) { return light.maps.passes_left() > 0; });
    if (found == lights_.end()) {
        const auto begun = begin(plan, method, exponent);
        if (!begun) return begun.error();
        found = lights_.begin();
    }
    lights_.splice(lights_.begin(), lights_, found);
    while (found->maps.passes_left()) {
        const auto ran = found->maps.run_pass();
        if (!ran) return ran.error();
        work.push_back(*ran);
        if (std::chrono::steady_clock::now() >= end) break;
    }
    return &*found;
}

void Lights::trim(std::initializer_list<const Light*> shown) {
    while (lights_.size() > MOST_LIGHTS &&
           std::find(shown.begin(), shown.end(), &lights_.back()) == shown.end())
        lights_.pop_back();
}

std::uint64_t Lights::bytes() const {
    std::uint64_t bytes = 0;
    std::set<std::uint64_t> levels; // plans that share them say the same of them
    for (const Light& light : lights_)
        for (const SceneResource& resource : light.maps.plan().resources()) {
            const std::string_view name = resource.name;
            if (name == "prefilter levels")
                levels.insert(resource.bytes);
            else if (resource.kept && name != "picture")
                bytes += resource.bytes;
        }
    for (const std::uint64_t shared : levels) bytes += shared;
    return bytes;
}

} // namespace lobelia::cli
