#include <lobelia/host/environment_upload.h>

#include <algorithm>
#include <functional>

#include <lobelia/panorama.h>

#include "host/averages.h"
#include "host/environment_plan.h"
#include "host/guard.h"
#include "host/resampling.h"

namespace lobelia::host {

namespace {

constexpr std::uint64_t PART = 1 << 18; // texels of a part

std::uint32_t rows_of(const Image& image) {
    return image.layers * image.height;
}

bool is_complete(const Image& image) {
    const bool shaped = image.layout == Layout::cube
                            ? image.layers == 6 && image.width == image.height
                            : image.layers == 1;
    return shaped && image.width > 0 && image.height > 0 &&
           image.texels.size() == std::size_t(4) * image.layers * image.height * image.width;
}

/// Work on rows of texels, done by some at a time.
struct Step {
    std::uint32_t rows;
    std::uint64_t texels; // that all rows read or write, whichever is more
    std::function<Outcome<Done>(std::uint32_t first, std::uint32_t count)> run;
    std::uint32_t done = 0; // rows

    Outcome<Done> go_on() {
        const std::uint64_t part = std::max<std::uint64_t>(PART * rows / texels, 1);
        const auto count = std::uint32_t(std::min<std::uint64_t>(part, rows - done));
        if (const auto ran = run(done, count); !ran) return ran;
        done += count;
        return Done{};
    }
};

} // namespace

struct EnvironmentUpload::State {
    Gpu& gpu;
    const Image& image;
    bool constant;
    EnvironmentPlan plan;
    GpuImage target; // what `image` is copied into
    std::optional<Resampling> resampling{};
    std::optional<Resizing> resizing{};
    std::vector<Step> steps{};

    Outcome<Done> add_steps();
    /// The pass of the plan that `job` carries out.
    template <class Job>
    void add_pass(const Job& job, PassReport& report, std::uint64_t texels) {
        steps.push_back(
            {job.rows(), texels, [this, &job, &report](std::uint32_t first, std::uint32_t count) {
                 return run_pass(gpu, report, [&](VkCommandBuffer commands) {
                     job.record(commands, first, count);
                 });
             }});
    }
};

Outcome<Done> EnvironmentUpload::State::add_steps() {
    steps.push_back(
        {rows_of(image), image.texels.size() / 4, [this](std::uint32_t first, std::uint32_t count) {
             return gpu.upload_rows(image, target, first, count);
         }});
    auto pass = plan.report.passes.begin();
    const auto larger = [](const GpuImage& one, const GpuImage& other) {
        return std::max(image_texels(one), image_texels(other));
    };
    if (image.layout == Layout::latlong) {
        auto made = Resampling::create(gpu, target, plan.face);
        if (!made) return made.error();
        resampling = std::move(*made);
        add_pass(resampling->job, *pass++, larger(target, resampling->cube));
    }
    const GpuImage& cube = resampling ? resampling->cube : target;
    auto made = Resizing::create(gpu, cube);
    if (!made) return made.error();
    resizing = std::move(*made);
    if (resizing) add_pass(resizing->job, *pass, larger(cube, resizing->cube));
    return Done{};
}

EnvironmentUpload::EnvironmentUpload(std::unique_ptr<State> state) : state_(std::move(state)) {}
EnvironmentUpload::EnvironmentUpload(EnvironmentUpload&&) noexcept = default;
EnvironmentUpload& EnvironmentUpload::operator=(EnvironmentUpload&&) noexcept = default;
EnvironmentUpload::~EnvironmentUpload() = default;

Outcome<EnvironmentUpload> EnvironmentUpload::begin(Gpu& gpu, const Image& image,
                                                    std::uint32_t face, Quality quality) {
    if (!is_complete(image))
        return Failure{"an environment is one panorama or six square faces of R G B A texels"};
    return guarded([&]() -> Outcome<EnvironmentUpload> {
        auto target = gpu.create_image({.width = image.width,
                                        .height = image.height,
                                        .layers = image.layers,
                                        .usage = ENVIRONMENT_USAGE,
                                        .cube = image.layout == Layout::cube});
        if (!target) return target.error();
        const EnvironmentShape shape = shape_of(image);
        auto state = std::make_unique<State>(State{gpu, image, shape.constant,
                                                   plan_environment(shape, face, quality),
                                                   std::move(*target)});
        if (const auto added = state->add_steps(); !added) return added.error();
        return EnvironmentUpload(std::move(state));
    });
}

double EnvironmentUpload::done() const {
    double done = 0, all = 0; // rows
    for (const Step& step : state_->steps) {
        done += step.done;
        all += step.rows;
    }
    return done / all;
}

Outcome<Done> EnvironmentUpload::go_on() {
    return guarded([&]() -> Outcome<Done> {
        for (Step& step : state_->steps)
            if (step.done < step.rows) return step.go_on();
        return Done{};
    });
}

GpuEnvironment EnvironmentUpload::take() {
    State& made = *state_;
    GpuEnvironment environment{.cube =
                                   std::move(made.resampling ? made.resampling->cube : made.target),
                               .report = std::move(made.plan.report),
                               .constant = made.constant};
    if (made.resampling) environment.panorama = std::move(made.target);
    if (made.resizing) environment.resized = std::move(made.resizing->cube);
    return environment;
}

Outcome<GpuEnvironment> upload_environment(Gpu& gpu, const Image& image, std::uint32_t face,
                                           Quality quality) {
    auto upload = EnvironmentUpload::begin(gpu, image, face, quality);
    if (!upload) return upload.error();
    while (upload->done() < 1.0)
        if (const auto done = upload->go_on(); !done) return done.error();
    return upload->take();
}

} // namespace lobelia::host
