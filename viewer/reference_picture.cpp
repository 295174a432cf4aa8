#include "reference_picture.h"

namespace lobelia::cli {

using host::Outcome;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr double MS_PER_UPDATE = 60.0; // while nothing moves
constexpr auto AFTER = 250ms;          // of stillness

/// Whether a reference of `a` serves `b`: all but the colours of the lobes that are there.
bool has_same_reference(const SphereView& a, const SphereView& b) {
    const auto key = [](const SphereView& v) {
        return std::tuple(v.camera.eye, v.camera.target, v.camera.up,
                          v.camera.vertical_field_of_view, is_black(v.material.diffuse),
                          is_black(v.material.specular), v.material.exponent,
                          v.environment_rotation, v.width, v.height);
    };
    return key(a) == key(b);
}

} // namespace

DrawingRequest reference_drawing(const host::ProgressiveReference& reference,
                                 const PictureRequest& request) {
    const SphereView& view = request.settings.view;
    const bool diffuse = !is_black(view.material.diffuse);
    const bool specular = !is_black(view.material.specular);
    return {.shading = {.method = diffuse || specular ? SphereMethod::reference
                                                      : SphereMethod::plain_split_sum, // black
                        .diffuse = diffuse,
                        .specular = specular,
                        .background = view.background},
            .sources = {.background = request.background,
                        .reference_diffuse = reference.diffuse(),
                        .reference_specular = reference.specular()},
            .view = view,
            .version = request.version};
}

void ReferencePicture::forget() {
    drawing_.forget();
    reference_.reset();
    view_.reset();
}

Outcome<Done> ReferencePicture::update(host::Gpu& gpu, const host::GpuEnvironment& environment,
                                       SpherePipelines& pipelines, const PictureRequest& request,
                                       FrameWork& work) {
    const SphereView& view = request.settings.view;
    if (!view_ || !has_same_reference(*view_, view)) {
        reference_.reset();
        view_ = view;
        asked_ = Clock::now();
    }
    if (!reference_) {
        if (Clock::now() - asked_ < AFTER) return Done{};
        auto reference = host::ProgressiveReference::create(gpu, environment, view);
        if (!reference) return reference.error();
        reference_ = std::move(*reference);
        ++version_;
        drawing_.forget();
    }
    if (reference_->done() < 1.0) {
        const double before = reference_->done();
        if (const auto done = reference_->advance(MS_PER_UPDATE); !done) return done;
        work.push_back({.name = "reference"});
        if (reference_->done() > before) drawing_.forget();
    }
    DrawingRequest drawing = reference_drawing(*reference_, request);
    drawing.version += version_ << 32;
    return drawing_.draw(gpu, pipelines, drawing, work);
}

} // namespace lobelia::cli
