#include <lobelia/host/environment_upload.h>

#include <algorithm>

#include <lobelia/panorama.h>

#include "host/averages.h"
#include "host/environment_plan.h"
#include "host/guard.h"
#include "host/resampling.h"

namespace lobelia::host {

namespace {

constexpr std::uint64_t PART = 1 << 20; // texels of a part

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

/// The next rows of `all` that hold a part's share of `texels`, one at least.
std::uint32_t next_rows(std::uint32_t done, std::uint32_t all, std::uint64_t texels) {
    const std::uint64_t rows = std::max<std::uint64_t>(PART * all / texels, 1);
    return std::uint32_t(std::min<std::uint64_t>(rows, all - done));
}

} // namespace

struct EnvironmentUpload::State {
    Gpu& gpu;
    const Image& image;
    bool constant;
    EnvironmentPlan plan;
    GpuImage target; // what `image` is copied into
    std::optional<Resampling> resampling{};
    std::uint32_t copied = 0, resampled = 0; // rows

    std::uint32_t rows_to_resample() const { return resampling ? resampling->job.rows() : 0; }
    Outcome<Done> go_on();
};

Outcome<Done> EnvironmentUpload::State::go_on() {
    const std::uint64_t texels = std::uint64_t(image.width) * rows_of(image);
    const std::uint64_t of_cube = std::uint64_t(plan.face) * rows_to_resample();
    if (copied < rows_of(image)) {
        const std::uint32_t rows = next_rows(copied, rows_of(image), texels);
        if (const auto done = gpu.upload_rows(image, target, copied, rows); !done) return done;
        copied += rows;
    } else if (resampled < rows_to_resample()) {
        const std::uint32_t rows =
            next_rows(resampled, rows_to_resample(), std::max(texels, of_cube));
        const auto done = run_pass(gpu, plan.report.passes.back(), [&](VkCommandBuffer commands) {
            resampling->job.record(commands, resampled, rows);
        });
        if (!done) return done;
        resampled += rows;
    }
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
        if (image.layout == Layout::latlong) {
            auto resampling = Resampling::create(gpu, state->target, state->plan.face);
            if (!resampling) return resampling.error();
            state->resampling = std::move(*resampling);
        }
        return EnvironmentUpload(std::move(state));
    });
}

double EnvironmentUpload::done() const {
    const double all = double(rows_of(state_->image)) + double(state_->rows_to_resample());
    return (double(state_->copied) + double(state_->resampled)) / all;
}

Outcome<Done> EnvironmentUpload::go_on() {
    return guarded([&] { return state_->go_on(); });
}

GpuEnvironment EnvironmentUpload::take() {
    State& made = *state_;
    if (!made.resampling)
        return {std::nullopt, std::move(made.target), std::move(made.plan.report), made.constant};
    return {std::move(made.target), std::move(made.resampling->cube), std::move(made.plan.report),
            made.constant};
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
