#include "stage.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lobelia::cli {

using host::Outcome;
using namespace std::chrono_literals;

namespace {

constexpr auto WORK_PER_UPDATE = 12ms;  // on maps: the rest of a frame is for drawing
constexpr double REFERENCE_MS = 60.0;   // likewise, while nothing moves
constexpr auto REFERENCE_AFTER = 250ms; // of stillness
constexpr std::size_t MOST_LIGHTS = 6;  // kept for going back to
constexpr float DARK = 1e-3f;           // of the mean: what errors of black count against

bool is_black(const std::array<float, 3>& colour) {
    return colour == std::array<float, 3>{};
}

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

bool needs_reference(const ViewState& state) {
    return state.errors || state.settings.method == SphereMethod::reference ||
           (state.split && state.other == SphereMethod::reference);
}

} // namespace

Outcome<Stage> Stage::create(host::Gpu& gpu) {
    auto pass = make_colour_pass(gpu.device().handle, Picture::FORMAT, Picture::LAYOUT);
    if (!pass) return pass.error();
    auto passes = LightPasses::create(gpu);
    if (!passes) return passes.error();
    return Stage(gpu, std::move(*passes), std::move(*pass));
}

Outcome<Done> Stage::set_environment(host::GpuEnvironment environment) {
    auto resized = host::resized_cube(*gpu_, environment);
    if (!resized) return resized.error();
    reference_.reset(); // reads the old one
    reference_view_.reset();
    for (Drawing* drawing : {&left_, &right_, &exact_}) drawing->forget();
    left_light_ = right_light_ = nullptr;
    lights_.clear();
    blurred_.reset();
    blurred_by_ = -1.0f;
    environment_ = std::make_unique<host::GpuEnvironment>(std::move(environment));
    resized_ = std::move(*resized);
    ++version_;
    return Done{};
}

std::uint64_t Stage::bytes() const {
    std::uint64_t bytes = 0;
    for (const Light& light : lights_) bytes += light.bytes();
    return bytes;
}

std::optional<double> Stage::reference_done() const {
    if (reference_) return reference_->done();
    return reference_view_ ? std::optional(0.0) : std::nullopt;
}

Outcome<Light*> Stage::light_for(const LightRequest& request, FrameWork& work,
                                 Clock::time_point end) {
    auto found = std::find_if(lights_.begin(), lights_.end(),
                              [&](const Light& light) { return light.request() == request; });
    // What was begun for another exponent is ended first: pictures follow while an edit goes on.
    if (found == lights_.end())
        found = std::find_if(lights_.begin(), lights_.end(), [&](const Light& light) {
            return light.passes_left() && light.request().method == request.method &&
                   light.request().quality == request.quality;
        });
    if (found == lights_.end()) {
        auto light =
            Light::create(*gpu_, passes_, resized_ ? *resized_ : environment_->cube, request);
        if (!light) return light.error();
        lights_.push_front(std::move(*light));
        found = lights_.begin();
    }
    lights_.splice(lights_.begin(), lights_, found);
    while (found->passes_left()) {
        const auto ran = found->run_pass(*gpu_);
        if (!ran) return ran.error();
        work.push_back(*ran);
        if (Clock::now() >= end) break;
    }
    return &*found;
}

Outcome<Done> Stage::draw_method(Drawing& drawing, Light*& shown, SphereMethod method,
                                 const ViewState& state, const SphereView& view, FrameWork& work,
                                 Clock::time_point end) {
    const LightRequest wanted =
        light_request(method, state.settings.quality, view.material.exponent);
    const auto light = light_for(wanted, work, end);
    if (!light) return light.error();
    const std::size_t left = (*light)->passes_left();
    if (left == 0) shown = *light;
    const bool ready = shown && shown->request() == wanted;
    busy_ |= !ready;
    if (!ready && (*light)->pass_count())
        maps_done_ = std::min(maps_done_, 1.0 - double(left) / double((*light)->pass_count()));
    if (!shown) return Done{};

    const LightRequest& made = shown->request();
    DrawingRequest request{.shading = {.method = made.method,
                                       .diffuse = !is_black(view.material.diffuse),
                                       .specular = !is_black(view.material.specular),
                                       .background = view.background,
                                       .specular_filter = shown->specular_filter(),
                                       .suns = shown->has_suns(),
                                       .samples = state.settings.samples},
                           .sources = shown->sources(),
                           .view = view,
                           .version = version_};
    if (made != light_request(made.method, made.quality, made.exponent + 1.0f))
        request.view.material.exponent = made.exponent; // maps are for it alone
    if (!request.shading.diffuse && !request.shading.specular)
        request.shading.method = SphereMethod::plain_split_sum; // black, and reads the least
    request.sources.background = blurred_ ? blurred_->view() : environment_->cube.view();
    return drawing.draw(*gpu_, pipelines_, pass_.get(), request, work);
}

Outcome<Done> Stage::update_background(const ViewState& state, FrameWork& work) {
    const bool blurred = state.background == Background::blurred;
    if (!blurred && blurred_) {
        blurred_.reset();
        ++version_;
    }
    if (!blurred || (blurred_ && blurred_by_ == state.blur)) return Done{};
    const auto maps = host::prefilter(
        *gpu_, *environment_, {.quality = Quality::fast, .exponents = {state.blur}, .width = 64});
    if (!maps) return maps.error();
    work.insert(work.end(), maps->report.passes.begin(), maps->report.passes.end());
    const host::Image& map = maps->maps.front();
    auto image =
        gpu_->create_image({.width = map.width,
                            .height = map.height,
                            .layers = 6,
                            .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                            .cube = true});
    if (!image) return image.error();
    if (const auto done = gpu_->upload(map, *image); !done) return done.error();
    blurred_ = std::move(*image);
    blurred_by_ = state.blur;
    ++version_;
    return Done{};
}

Outcome<Done> Stage::update_reference(const ViewState& state, const SphereView& view,
                                      FrameWork& work) {
    if (!needs_reference(state)) {
        reference_.reset();
        reference_view_.reset();
        return Done{};
    }
    if (!reference_view_ || !has_same_reference(*reference_view_, view)) {
        reference_.reset();
        reference_view_ = view;
        reference_asked_ = Clock::now();
    }
    busy_ = true;
    if (!reference_) {
        if (Clock::now() - reference_asked_ < REFERENCE_AFTER) return Done{};
        auto reference = host::ProgressiveReference::create(*gpu_, *environment_, view);
        if (!reference) return reference.error();
        reference_ = std::move(*reference);
        ++reference_version_;
        exact_.forget();
    }
    if (reference_->done() < 1.0) {
        const double before = reference_->done();
        if (const auto done = reference_->advance(REFERENCE_MS); !done) return done;
        work.push_back({.name = "reference"});
        if (reference_->done() > before) exact_.forget();
    }
    busy_ = reference_->done() < 1.0 || maps_done_ < 1.0;
    DrawingRequest request{
        .shading = {.method = SphereMethod::reference,
                    .diffuse = !is_black(view.material.diffuse),
                    .specular = !is_black(view.material.specular),
                    .background = view.background},
        .sources = {.background = blurred_ ? blurred_->view() : environment_->cube.view(),
                    .reference_diffuse = reference_->diffuse(),
                    .reference_specular = reference_->specular()},
        .view = view,
        .version = version_ + (reference_version_ << 32)};
    if (!request.shading.diffuse && !request.shading.specular)
        request.shading.method = SphereMethod::plain_split_sum;
    return exact_.draw(*gpu_, pipelines_, pass_.get(), request, work);
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

Outcome<Done> Stage::update(const ViewState& state, VkExtent2D extent, FrameWork& work) {
    busy_ = false;
    maps_done_ = 1.0;
    if (!environment_) return Done{};
    if (const auto fitted = fit_unknown(extent); !fitted) return fitted;
    if (const auto done = update_background(state, work); !done) return done;
    const SphereView view = shown_view(state, extent);
    const auto end = Clock::now() + WORK_PER_UPDATE;
    const auto drawn_by = [&](SphereMethod method) {
        return method == SphereMethod::reference ? host::method_for(state.settings.quality)
                                                 : method;
    };
    if (const auto done = draw_method(left_, left_light_, drawn_by(state.settings.method), state,
                                      view, work, end);
        !done)
        return done;
    if (state.split) {
        const auto done =
            draw_method(right_, right_light_, drawn_by(state.other), state, view, work, end);
        if (!done) return done;
    } else {
        right_light_ = nullptr;
    }
    while (lights_.size() > MOST_LIGHTS && &lights_.back() != left_light_ &&
           &lights_.back() != right_light_)
        lights_.pop_back();
    return update_reference(state, view, work);
}

const Picture& Stage::picture(const ViewState& state, bool right) const {
    return *(right && state.split && right_light_ && right_.picture() ? right_ : left_).picture();
}

DisplaySources Stage::display_sources(const ViewState& state) const {
    const bool has_reference = reference_ && exact_.picture();
    const Drawing& reference = has_reference ? exact_ : left_;
    return {.first = picture(state, false).view(),
            .second = picture(state, true).view(),
            .reference = reference.picture()->view(),
            .known = has_reference ? reference_->known() : unknown_->handle()};
}

DisplayParams Stage::display_params(const ViewState& state, VkExtent2D extent) const {
    const Material material = shown_view(state, extent).material;
    float brightest = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        brightest = std::max(brightest, material.diffuse[c] + material.specular[c]);
    const float light = reference_ ? float(reference_->mean_light()) : 0.0f;
    return {.scale = std::exp2(state.exposure),
            .divider = state.split ? std::round(state.divider * float(extent.width)) : 1e9f,
            .errors = state.errors,
            .exact = (state.settings.method == SphereMethod::reference ? 1u : 0u) |
                     (state.other == SphereMethod::reference ? 2u : 0u),
            .dark = std::max(DARK * light * brightest, 1e-30f),
            .width = left_.picture()->extent().width};
}

Outcome<host::Image> Stage::download(const ViewState& state, bool right) {
    auto image = picture(state, right).download(*gpu_);
    const SphereMethod method = right && state.split ? state.other : state.settings.method;
    if (!image || method != SphereMethod::reference || !reference_ || !exact_.picture())
        return image;
    const auto exact = exact_.picture()->download(*gpu_);
    if (!exact) return exact.error();
    for (std::uint32_t y = 0; y < image->height; ++y)
        for (std::uint32_t x = 0; x < image->width; ++x)
            if (reference_->is_known(x, y))
                std::copy_n(exact->texel(0, x, y), 4, image->texel(0, x, y));
    return image;
}

Outcome<Stage::Probe> Stage::probe(const ViewState& state, std::uint32_t x, std::uint32_t y) {
    const SphereView view = shown_view(state, left_.picture()->extent());
    const bool right = state.split && float(x) >= state.divider * float(view.width);
    auto values = download(state, right);
    if (!values) return values.error();
    Probe probe;
    std::copy_n(values->texel(0, x, y), 3, probe.shown.begin());

    auto reference = host::ProgressiveReference::create(*gpu_, *environment_, view);
    if (!reference) return reference.error();
    if (const auto done = reference->integrate(x, y); !done) return done.error();
    Drawing drawing;
    FrameWork work;
    const DrawingRequest request{
        .shading = {.method = SphereMethod::reference,
                    .diffuse = !is_black(view.material.diffuse),
                    .specular = !is_black(view.material.specular),
                    .background = view.background},
        .sources = {.background = blurred_ ? blurred_->view() : environment_->cube.view(),
                    .reference_diffuse = reference->diffuse(),
                    .reference_specular = reference->specular()},
        .view = view};
    if (const auto done = drawing.draw(*gpu_, pipelines_, pass_.get(), request, work); !done)
        return done.error();
    values = drawing.picture()->download(*gpu_);
    if (!values) return values.error();
    std::copy_n(values->texel(0, x, y), 3, probe.exact.begin());
    return probe;
}

} // namespace lobelia::cli
