// measure_plan [live]
//
// What plans save: for the scenes of docs/plan.md the passes, bytes and time, against everything,
// and the time that the plan predicts from the device's own rates.
//
// Time: process CPU time of recording and running all passes and draws in one submission, median of
// nine, warm. At the end, or alone, a live environment of 128 texels a face, whose maps are made
// anew over frames with a sixteenth of the predicted time each.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <lobelia/host/plan.h>

#include "host/drawing.h"
#include "host/maps.h"
#include "support/gpu_sources.h"
#include "support/plan_scenes.h"

namespace lobelia::test {
namespace {

constexpr int RUNS = 9;

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

SphereView view_of(const SceneMaterial* material, const Scene& scene, std::size_t draws) {
    SphereView view{.background = scene.background,
                    .width = scene.width,
                    .height = std::uint32_t(scene.height / draws)};
    if (material)
        view.material = {material->diffuse, material->specular,
                         std::sqrt(material->least_exponent * material->most_exponent)};
    return view;
}

/// The scene as an engine holds it: maps, tables and a draw for each material.
class Frame {
public:
    Frame(host::Gpu& gpu, const host::GpuEnvironment& environment, const PlanScene& named)
        : gpu_(gpu), scene_(named.scene()), plan_(value_of(ScenePlan::make(scene_))),
          target_(value_of(host::ColourTarget::create(gpu, scene_.width, scene_.height))) {
        SphereSources sources{.background = environment.cube.view()};
        if (plan_.environment_is_its_maps())
            sources.diffuse = sources.specular = sources.background;
        if (plan_.prefilter()) {
            maps_.emplace(value_of(host::bind_maps(gpu, environment, *plan_.prefilter())));
            sources.prefilter_state = maps_->maps.state.handle();
            for (const host::GpuImage& image : maps_->maps.images) sources.diffuse = image.view();
            if (maps_->maps.ladder) sources.ladder = maps_->maps.ladder->view();
        }
        if (plan_.clipped_tables()) {
            host::PassReport upload;
            tables_.emplace(value_of(host::make_clipped_tables(gpu, upload)));
            sources.clipped_tables = tables_->view();
        }
        const Sphere sphere = value_of(
            Sphere::create(gpu.device(), {.render_pass = target_.render_pass()}, plan_.shading()));
        job_.emplace(value_of(sphere.bind(sources)));
        const std::size_t draws = std::max<std::size_t>(named.materials.size(), 1);
        for (std::size_t i = 0; i < draws; ++i)
            views_.push_back(
                view_of(named.materials.empty() ? nullptr : &named.materials[i], scene_, draws));
    }

    const ScenePlan& plan() const { return plan_; }

    double milliseconds() {
        std::vector<double> times;
        for (int run = 0; run < RUNS + 2; ++run) {
            host::PassReport report;
            value_of(host::run_pass(gpu_, report, [&](VkCommandBuffer commands) {
                if (maps_) maps_->job.record(commands, 0, maps_->plan.pass_count());
                target_.record(commands, [&](VkCommandBuffer inside) {
                    for (const SphereView& view : views_) job_->record(inside, view);
                });
            }));
            if (run >= 2) times.push_back(*report.cpu_ms);
        }
        return median(times);
    }

    double predicted() {
        host::RenderSettings settings{.view = views_.front(), .method = scene_.method};
        const host::Rates rates = value_of(host::measure_rates(gpu_, settings));
        double sum = 0;
        for (const ScenePass& pass : plan().passes())
            if (pass.dispatches > 0)
                sum += host::predicted_milliseconds(rates, pass.name, pass.work);
        return sum;
    }

private:
    host::Gpu& gpu_;
    Scene scene_;
    ScenePlan plan_;
    host::ColourTarget target_;
    std::optional<host::MapsJob> maps_;
    std::optional<host::GpuImage> tables_;
    std::optional<SphereJob> job_;
    std::vector<SphereView> views_;
};

void run() {
    host::Gpu gpu = value_of(host::Gpu::create());
    const host::GpuEnvironment environment = value_of(host::make_builtin_environment(gpu));
    std::printf("| scene | passes | MB | ms | of everything | predicted ms |\n");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    double everything = 0;
    std::vector<double> ratios;
    for (const PlanScene& named : plan_scenes()) {
        Frame frame(gpu, environment, named);
        const double measured = frame.milliseconds();
        const double predicted = frame.predicted();
        if (everything == 0) everything = measured;
        std::uint64_t bytes = 0;
        for (const ScenePass& pass : frame.plan().passes())
            bytes += pass.bytes_read + pass.bytes_written;
        std::printf("| %s | %zu | %.2f | %.1f | %.2f | %.1f |\n", named.name.c_str(),
                    frame.plan().passes().size(), double(bytes) * 1e-6, measured,
                    measured / everything, predicted);
        std::fflush(stdout);
        ratios.push_back(std::max(predicted / measured, measured / predicted));
    }
    std::printf("\npredicted and measured differ by a factor of %.2f on the median, %.2f at most\n",
                median(ratios), *std::max_element(ratios.begin(), ratios.end()));
}

void run_live() {
    host::Gpu gpu = value_of(host::Gpu::create());
    const host::GpuEnvironment environment = value_of(host::make_builtin_environment(gpu, 128));
    constexpr float EXPONENTS[] = {2048, 512, 128, 32, 8, 2};
    const host::MapsJob maps =
        value_of(host::bind_maps(gpu, environment, {.exponents = EXPONENTS, .lambert = true}));
    const host::Rates known = value_of(host::measure_rates(gpu, host::RenderSettings{}));
    std::vector<PassRate> rates;
    for (const auto& [name, rate] : known) rates.push_back({name.c_str(), rate});
    double whole = 0;
    for (std::uint32_t i = 0; i < maps.plan.pass_count(); ++i) {
        const PrefilterPass pass = maps.plan.pass(i);
        whole += predicted_milliseconds(std::span<const PassRate>(rates), pass.name, pass.work);
    }
    const double budget = whole / 16;
    std::vector<double> times;
    std::uint32_t frames = 0;
    for (int run = 0; run < RUNS; ++run) { // each from the start; the first ones warm it
        frames = 0;
        for (PrefilterPosition at; at.pass < maps.plan.pass_count(); ++frames) {
            host::PassReport report;
            value_of(host::run_pass(gpu, report, [&](VkCommandBuffer commands) {
                at = maps.job.record(commands, at, budget, rates);
            }));
            if (run >= 2) times.push_back(*report.cpu_ms / budget);
        }
    }
    std::printf("\nlive, 128 texels a face: %.1f ms over %u frames, told %u; a frame takes %.2f of "
                "its budget on the median, %.2f at most\n",
                whole, frames, maps.job.frames(budget, rates), median(times),
                *std::max_element(times.begin(), times.end()));
}

} // namespace
} // namespace lobelia::test

int main(int argc, char**) {
    try {
        if (argc < 2) lobelia::test::run();
        lobelia::test::run_live();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "measure_plan: %s\n", error.what());
        return 1;
    }
}
