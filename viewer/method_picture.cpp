#include "method_picture.h"

#include "view_state.h"

namespace lobelia::cli {

using host::Outcome;

void MethodPicture::forget() {
    planned_.reset();
    light_ = nullptr;
    drawing_.forget();
}

Outcome<Done> MethodPicture::plan(const Lights& lights, const PictureRequest& request) {
    const host::RenderSettings& settings = request.settings;
    const SphereView& view = settings.view;
    const PlanKey key(settings.method, settings.quality, settings.samples, view.material.exponent,
                      is_black(view.material.diffuse), is_black(view.material.specular),
                      view.background, host::sees_sphere(view), view.width, view.height);
    if (planned_ == key) return Done{};
    auto plan = lights.plan(settings, view.material.exponent);
    if (!plan) return plan.error();
    plan_ = std::move(*plan);
    planned_ = key;
    return Done{};
}

Outcome<Done> MethodPicture::update(host::Gpu& gpu, Lights& lights, SpherePipelines& pipelines,
                                    const PictureRequest& request, FrameWork& work,
                                    std::chrono::steady_clock::time_point end) {
    if (const auto planned = plan(lights, request); !planned) return planned;
    const SphereView& view = request.settings.view;
    const auto advanced =
        lights.advance(*plan_, request.settings.method, view.material.exponent, work, end);
    if (!advanced) return advanced.error();
    Lights::Light& light = **advanced;
    const std::size_t left = light.maps.passes_left();
    ready_ = left == 0 && Lights::serves(light, *plan_);
    maps_done_ = ready_ ? 1.0 : 1.0 - double(left + 1) / double(light.maps.pass_count() + 1);
    if (ready_) light.exponent = view.material.exponent;
    if (ready_ || (left == 0 && light.method == request.settings.method)) light_ = &light;
    if (!light_) return Done{};

    DrawingRequest drawing{.shading = light_->maps.shading(ready_ ? *plan_ : light_->maps.plan()),
                           .sources = light_->maps.sources(),
                           .view = view,
                           .version = request.version};
    drawing.shading.background = view.background;
    drawing.view.material.exponent = light_->exponent; // maps may be for it alone
    drawing.sources.background = request.background;
    return drawing_.draw(gpu, pipelines, drawing, work);
}

} // namespace lobelia::cli
