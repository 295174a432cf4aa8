#include "stage.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lobelia::cli {

using host::Outcome;
using namespace std::chrono_literals;

namespace {

constexpr auto WORK_PER_UPDATE = 12ms; // on maps: the rest of a frame is for drawing
constexpr float DARK = 1e-3f;          // of the mean: what errors of black count against

bool needs_reference(const ViewState& state) {
    return state.errors || state.settings.method == SphereMethod::reference ||
           (state.split && state.other == SphereMethod::reference);
}

} // namespace

Outcome<Stage> Stage::create(host::Gpu& gpu) {
    auto pipelines = SpherePipelines::create(gpu);
    if (!pipelines) return pipelines.error();
    return Stage(gpu, std::move(*pipelines));
}

void Stage::set_environment(host::GpuEnvironment environment) {
    reference_.forget(); // reads the old one
    left_.forget();
    right_.forget();
    background_.forget();
    lights_.emplace(*gpu_, passes_, std::move(environment));
    ++environments_;
}

std::optional<double> Stage::reference_done() const {
    return reference_.is_asked_for() ? std::optional(reference_.done()) : std::nullopt;
}

PictureRequest Stage::request_for(const ViewState& state, VkExtent2D extent,
                                  SphereMethod method) const {
    PictureRequest request{.settings = state.settings,
                           .background = background_.light()
                                             ? background_.light()->maps.sources().background
                                             : environment()->cube.view(),
                           .version = environments_ + background_.version()};
    request.settings.view = shown_view(state, extent);
    // Under the reference, while that sharpens, lies what the quality stands for.
    request.settings.method =
        method == SphereMethod::reference ? host::method_for(state.settings.quality) : method;
    return request;
}

Outcome<Done> Stage::update_pictures(const ViewState& state, VkExtent2D extent, FrameWork& work) {
    const auto end = std::chrono::steady_clock::now() + WORK_PER_UPDATE;
    if (const auto done = background_.update(*lights_, state, work, end); !done) return done;
    busy_ |= !background_.is_ready();
    const auto update = [&](MethodPicture& side, SphereMethod method) {
        const auto done =
            side.update(*gpu_, *lights_, pipelines_, request_for(state, extent, method), work, end);
        busy_ |= !side.is_ready();
        maps_done_ = std::min(maps_done_, side.maps_done());
        return done;
    };
    if (const auto done = update(left_, state.settings.method); !done) return done;
    if (state.split) {
        if (const auto done = update(right_, state.other); !done) return done;
    } else {
        right_.leave();
    }
    lights_->trim({left_.light(), right_.light(), background_.light()});
    return Done{};
}

Outcome<Done> Stage::update(const ViewState& state, VkExtent2D extent, FrameWork& work) {
    busy_ = false;
    maps_done_ = 1.0;
    if (!lights_) return Done{};
    if (const auto fitted = fit_unknown(extent); !fitted) return fitted;
    if (const auto done = update_pictures(state, extent, work); !done) return done;
    if (!needs_reference(state)) {
        reference_.forget();
        return Done{};
    }
    const auto done = reference_.update(*gpu_, *environment(), pipelines_,
                                        request_for(state, extent, SphereMethod::reference), work);
    busy_ |= reference_.is_busy();
    return done;
}

Outcome<Done> Stage::fit_unknown(VkExtent2D extent) {
    const VkDeviceSize bytes = VkDeviceSize(4) * extent.width * extent.height;
    if (unknown_ && unknown_->size() == bytes) return Done{};
    auto buffer =
        gpu_->create_buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, host::Memory::host);
    if (!buffer) return buffer.error();
    std::memset(buffer->data(), 0, bytes);
    unknown_ = std::move(*buffer);
    return Done{};
}

const Picture& Stage::picture(const ViewState& state, bool right) const {
    return *(right && state.split && right_.light() && right_.picture() ? right_ : left_).picture();
}

DisplaySources Stage::display_sources(const ViewState& state) const {
    const host::ProgressiveReference* const reference = reference_.values();
    return {.first = picture(state, false).view(),
            .second = picture(state, true).view(),
            .reference = (reference ? reference_.picture() : left_.picture())->view(),
            .known = reference ? reference->known() : unknown_->handle()};
}

DisplayVariant Stage::display_variant(const ViewState& state) const {
    return {.split = state.split,
            .errors = state.errors,
            .exact = (state.settings.method == SphereMethod::reference ? 1u : 0u) |
                     (state.split && state.other == SphereMethod::reference ? 2u : 0u)};
}

DisplayParams Stage::display_params(const ViewState& state, VkExtent2D extent) const {
    const Material material = shown_view(state, extent).material;
    float brightest = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        brightest = std::max(brightest, material.diffuse[c] + material.specular[c]);
    const host::ProgressiveReference* const reference = reference_.values();
    const float light = reference ? float(reference->mean_light()) : 0.0f;
    return {.scale = std::exp2(state.exposure),
            .divider = std::round(state.divider * float(extent.width)),
            .dark = std::max(DARK * light * brightest, 1e-30f),
            .width = left_.picture()->extent().width};
}

Outcome<host::Image> Stage::download(const ViewState& state, bool right) {
    auto image = picture(state, right).download(*gpu_);
    const SphereMethod method = right && state.split ? state.other : state.settings.method;
    const host::ProgressiveReference* const reference = reference_.values();
    if (!image || method != SphereMethod::reference || !reference) return image;
    const auto exact = reference_.picture()->download(*gpu_);
    if (!exact) return exact.error();
    for (std::uint32_t y = 0; y < image->height; ++y)
        for (std::uint32_t x = 0; x < image->width; ++x)
            if (reference->is_known(x, y))
                std::copy_n(exact->texel(0, x, y), 4, image->texel(0, x, y));
    return image;
}

Outcome<std::optional<Pick>> Stage::pick(const ViewState& state, std::uint32_t x, std::uint32_t y) {
    const PictureRequest request =
        request_for(state, left_.picture()->extent(), SphereMethod::reference);
    const SphereView& view = request.settings.view;
    const auto directions = surface_at(view, x, y);
    if (!directions) return std::optional<Pick>{};
    Pick pick{x, y, *directions, view.material.exponent};
    const bool right = state.split && float(x) >= state.divider * float(view.width);
    auto values = download(state, right);
    if (!values) return values.error();
    std::copy_n(values->texel(0, x, y), 3, pick.shown.begin());

    auto reference = host::ProgressiveReference::create(*gpu_, *environment(), view);
    if (!reference) return reference.error();
    if (const auto done = reference->integrate(x, y); !done) return done.error();
    Drawing drawing;
    FrameWork work;
    const auto drawn =
        drawing.draw(*gpu_, pipelines_, reference_drawing(*reference, request), work);
    if (!drawn) return drawn.error();
    values = drawing.picture()->download(*gpu_);
    if (!values) return values.error();
    std::copy_n(values->texel(0, x, y), 3, pick.exact.begin());
    return std::optional(pick);
}

} // namespace lobelia::cli
