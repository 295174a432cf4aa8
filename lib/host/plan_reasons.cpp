#include "host/plan_reasons.h"

#include <cmath>

#include "host/averages.h"
#include "host/camera.h"
#include "host/checks.h"
#include "host/scene_plan.h"
#include "host/text.h"

namespace lobelia::host {

namespace {

struct Total {
    double milliseconds = 0;
    double bytes = 0;
};

template <class Pass>
void add(Total& total, const Pass& pass, const Rates& rates) {
    total.milliseconds += predicted_milliseconds(rates, pass.name, pass.work);
    total.bytes += double(pass.bytes_read + pass.bytes_written);
}

Total total_of(const ScenePlan& plan, const Rates& rates) {
    Total total;
    for (const ScenePass& pass : plan.passes()) add(total, pass, rates);
    return total;
}

Total total_of(const PrefilterPlan& plan, const Rates& rates) {
    Total total;
    for (std::uint32_t i = 0; i < plan.pass_count(); ++i) add(total, plan.pass(i), rates);
    return total;
}

PlanReason reason(const char* effect, bool in, std::string why, const Total& now,
                  const Total& other) {
    return {effect, in, std::move(why), std::abs(now.milliseconds - other.milliseconds),
            std::uint64_t(std::abs(now.bytes - other.bytes))};
}

std::string lobe_why(const char* name, bool seen, bool in) {
    if (!seen) return "the sphere is out of the picture";
    return std::string(name) + (in ? " is above 0" : " is 0");
}

std::string levels_why(std::uint32_t used, std::uint32_t face) {
    const std::string have = "the source has faces of " + std::to_string(face) + " texels, ";
    return have + (used == face ? "and the sharpest lobe needs them"
                                : "and the sharpest lobe needs " + std::to_string(used));
}

/// The same plan with one thing turned.
struct Turned {
    const Gpu& gpu;
    KnownEnvironment environment;
    RenderSettings settings;
    const Rates& rates;

    Outcome<Total> total(const auto& turn) const {
        Turned other = *this;
        turn(other);
        const auto plan =
            plan_scene(gpu, other.environment.face, other.environment.constant, other.settings);
        if (!plan) return plan.error();
        return total_of(*plan, rates);
    }
};

void turn_colour(std::array<float, 3>& colour) {
    colour = is_black(colour) ? std::array<float, 3>{0.5f, 0.5f, 0.5f} : std::array<float, 3>{};
}

} // namespace

Outcome<std::vector<PlanReason>> render_reasons(const Gpu& gpu, const KnownEnvironment& environment,
                                                const RenderSettings& settings,
                                                const Rates& rates) {
    const auto plan = plan_scene(gpu, environment.face, environment.constant, settings);
    if (!plan) return plan.error();
    const Total now = total_of(*plan, rates);
    const SphereShading& shading = plan->shading();
    const bool seen = sees_sphere(settings.view);
    const bool lit = shading.diffuse || shading.specular;
    const Turned turned{gpu, environment, settings, rates};
    const auto diffuse =
        turned.total([](Turned& t) { turn_colour(t.settings.view.material.diffuse); });
    if (!diffuse) return diffuse.error();
    const auto specular =
        turned.total([](Turned& t) { turn_colour(t.settings.view.material.specular); });
    if (!specular) return specular.error();
    const auto background =
        turned.total([](Turned& t) { t.settings.view.background = !t.settings.view.background; });
    if (!background) return background.error();
    const auto prefilter =
        turned.total([](Turned& t) { t.environment.constant = !t.environment.constant; });
    if (!prefilter) return prefilter.error();

    std::vector<PlanReason> reasons;
    reasons.push_back(reason("diffuse light", shading.diffuse,
                             lobe_why("kd", seen, shading.diffuse), now, *diffuse));
    reasons.push_back(reason("specular light", shading.specular,
                             lobe_why("ks", seen, shading.specular), now, *specular));
    reasons.push_back(reason("background", settings.view.background,
                             !settings.view.background ? "it is hidden"
                             : plan->background_map()  ? "it is shown, blurred"
                                                       : "it is shown",
                             now, *background));
    const bool maps = plan->prefilter() != nullptr;
    reasons.push_back(reason("prefiltered maps", maps,
                             maps   ? lit ? "a lobe reads them" : "the background is one"
                             : !lit ? "nothing is lit"
                             : environment.constant
                                 ? "the environment has one colour, which is every lobe's average"
                                 : "the method reads none",
                             now, *prefilter));
    if (maps) {
        const std::uint32_t used = plan->prefilter()->finest_level();
        const std::uint32_t face = plan->prefilter()->source_size();
        reasons.push_back({"full-resolution levels", used == face, levels_why(used, face), 0, 0});
    }
    if (const ScenePass* tables = find_pass(*plan, "clipped tables"))
        reasons.push_back(reason("clipped tables", true,
                                 "lobes that the horizon cuts are read by them", {},
                                 {predicted_milliseconds(rates, tables->name, tables->work),
                                  double(tables->bytes_read + tables->bytes_written)}));
    const bool suns = maps && plan->clipped_tables();
    reasons.push_back({"suns in the shader", suns,
                       suns   ? "found on the device while the maps are made; without any, the "
                                "sphere pass is compiled without them"
                       : maps ? "the maps' readers add them where the device finds some"
                              : "no maps, so none are taken out of them",
                       0, 0});
    return reasons;
}

Outcome<std::vector<PlanReason>>
prefilter_reasons(std::uint32_t face, const PrefilterSettings& settings, const Rates& rates) {
    const auto plan_of = [&](std::span<const float> exponents) {
        return PrefilterPlan::make(
            {.exponents = exponents, .quality = settings.quality, .source_size = face});
    };
    const auto plan = plan_of(settings.exponents);
    if (!plan) return core_failure(plan.error());
    const Total now = total_of(*plan, rates);
    std::vector<PlanReason> reasons;
    for (std::size_t i = 0; i < settings.exponents.size(); ++i) {
        std::vector<float> others = settings.exponents;
        others.erase(others.begin() + std::ptrdiff_t(i));
        Total without;
        if (!others.empty()) {
            const auto fewer = plan_of(others);
            if (!fewer) return core_failure(fewer.error());
            without = total_of(*fewer, rates);
        }
        reasons.push_back(reason(("map n=" + number_text(settings.exponents[i])).c_str(), true,
                                 "it is asked for", now, without));
    }
    reasons.push_back({"full-resolution levels", plan->finest_level() == face,
                       levels_why(plan->finest_level(), face), 0, 0});
    return reasons;
}

} // namespace lobelia::host
