#include <algorithm>

#include <lobelia/clipped_tables.h>
#include <lobelia/host/plan.h>

#include "host/averages.h"
#include "host/drawing.h"
#include "host/environment_plan.h"
#include "host/maps.h"
#include "host/scene_plan.h"

namespace lobelia::host {

namespace {

// Of the environment that passes are timed on: no size that prefilters read, so that making it one
// is timed, too.
constexpr std::uint32_t FACE = 96;
constexpr std::uint32_t PICTURE = 192;
constexpr std::uint32_t REFERENCE_PICTURE = 16;
constexpr std::uint32_t MAP_FACE = 32;
constexpr int RUNS = 5;

/// What passes take, by their names.
class Timings {
public:
    static Outcome<Timings> create(Gpu& gpu) {
        Timings timings(gpu);
        const auto empty = timings.median(
            [&](PassReport& report) { return run_pass(gpu, report, [](VkCommandBuffer) {}); });
        if (!empty) return empty.error();
        timings.overhead_ = *empty;
        return timings;
    }

    /// Runs a pass until it is warm and then several times.
    Outcome<Done> add(const char* name, double work,
                      const std::function<Outcome<Done>(PassReport&)>& run) {
        const auto milliseconds = median(run);
        if (!milliseconds) return milliseconds.error();
        add(name, work, *milliseconds);
        return Done{};
    }
    /// Of a pass that ran before.
    void add(const PassReport& ran, double work) { add(ran.name, work, time_of(ran)); }
    Rates rates() const {
        Rates found;
        for (const auto& [name, sum] : sums_)
            if (sum.work > 0) found[name] = sum.milliseconds / sum.work;
        return found;
    }

private:
    struct Sum {
        double work = 0, milliseconds = 0;
    };
    Gpu* gpu_;
    double overhead_ = 0; // of a submission
    std::map<std::string, Sum> sums_;

    explicit Timings(Gpu& gpu) : gpu_(&gpu) {}

    void add(const std::string& name, double work, double milliseconds) {
        Sum& sum = sums_[name];
        sum.work += work;
        sum.milliseconds += std::max(milliseconds - overhead_, 0.0);
    }
    double time_of(const PassReport& ran) const {
        const bool by_device = ran.gpu_ms && gpu_->description().type != "cpu";
        return by_device ? *ran.gpu_ms : ran.cpu_ms.value_or(0.0);
    }
    Outcome<double> median(const std::function<Outcome<Done>(PassReport&)>& run) const {
        std::vector<double> times;
        for (int i = 0; i <= RUNS; ++i) {
            PassReport report;
            if (const auto done = run(report); !done) return done.error();
            if (i > 0) times.push_back(time_of(report));
        }
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    }
};

/// Every kind of pass of the prefilter.
Outcome<Done> add_chain(Gpu& gpu, Timings& timings, const GpuEnvironment& environment,
                        Quality quality) {
    constexpr float EXPONENTS[] = {2048, 700, 64, 8, 0.5f};
    const auto bound = bind_maps(gpu, environment,
                                 {.exponents = EXPONENTS,
                                  .lambert = true,
                                  .ladder = ladder_for(Taps::two, 200, 200),
                                  .quality = quality});
    if (!bound) return bound.error();
    for (std::uint32_t i = 0; i < bound->plan.pass_count(); ++i) {
        const PrefilterPass pass = bound->plan.pass(i);
        const auto added = timings.add(pass.name, pass.work, [&](PassReport& report) {
            return run_pass(gpu, report,
                            [&](VkCommandBuffer commands) { bound->job.record(commands, i, 1); });
        });
        if (!added) return added.error();
    }
    return Done{};
}

/// What the method makes for itself, as it ran once, and its draw.
Outcome<Done> add_drawing(Gpu& gpu, Timings& timings, const GpuEnvironment& environment,
                          RenderSettings settings) {
    const bool reference = settings.method == SphereMethod::reference;
    settings.view.width = settings.view.height = reference ? REFERENCE_PICTURE : PICTURE;
    const Rates chain = timings.rates(); // of passes that are timed by themselves
    const auto inputs = make_sphere_inputs(gpu, environment, settings, {});
    if (!inputs) return inputs.error();
    if (!inputs->plan.draws()) return Done{};
    for (const PassReport& pass : inputs->report.passes) {
        const float exponent =
            pass.name == "diffuse reference" ? 1.0f : settings.view.material.exponent;
        if (chain.contains(pass.name)) continue;
        const ScenePass* const planned = find_pass(inputs->plan, pass.name);
        timings.add(pass, planned ? planned->work : exact_work(pass, exponent)); // references
    }
    const auto drawing = Drawing::create(gpu, *inputs, settings.view);
    if (!drawing) return drawing.error();
    const ScenePass& draw = inputs->plan.passes().back();
    return timings.add(draw.name, draw.work,
                       [&](PassReport& report) { return drawing->run(gpu, report); });
}

/// What the method makes of a list of directions.
Outcome<Done> add_maps(Gpu& gpu, Timings& timings, const GpuEnvironment& environment,
                       PrefilterSettings settings) {
    settings.exponents.resize(1);
    settings.layout = Layout::cube;
    settings.levels = false;
    settings.width = MAP_FACE;
    for (int run = 0; run < 2; ++run) { // the second is warm
        const auto made = prefilter(gpu, environment, settings);
        if (!made) return made.error();
        for (const PassReport& pass : made->report.passes) {
            if (run == 0) continue;
            if (pass.name == "exact")
                timings.add(pass, exact_work(pass, settings.exponents.front()));
            else if (pass.name == "read map" || pass.name == "mips")
                timings.add(pass, double(pass.invocations));
            else if (settings.method != PrefilterMethod::chain)
                timings.add(pass, double(pass.invocations) * settings.samples);
        }
    }
    return Done{};
}

Outcome<Rates> measure(Gpu& gpu, Quality quality,
                       const std::function<Outcome<Done>(Timings&, const GpuEnvironment&)>& more) {
    auto timings = Timings::create(gpu);
    if (!timings) return timings.error();
    const auto environment = make_builtin_environment(gpu, FACE);
    if (!environment) return environment.error();
    const EnvironmentPlan plan = plan_environment(builtin_shape(), FACE, quality);
    for (std::size_t i = 0; i < plan.work.size(); ++i)
        timings->add(environment->report.passes[i], plan.work[i]);
    if (const auto added = add_chain(gpu, *timings, *environment, quality); !added)
        return added.error();
    if (const auto added = more(*timings, *environment); !added) return added.error();
    return timings->rates();
}

} // namespace

Outcome<Rates> measure_rates(Gpu& gpu, const RenderSettings& settings) {
    return measure(gpu, settings.quality, [&](Timings& timings, const GpuEnvironment& environment) {
        return add_drawing(gpu, timings, environment, settings);
    });
}

Outcome<Rates> measure_rates(Gpu& gpu, const PrefilterSettings& settings) {
    return measure(gpu, settings.quality, [&](Timings& timings, const GpuEnvironment& environment) {
        return add_maps(gpu, timings, environment, settings);
    });
}

} // namespace lobelia::host
