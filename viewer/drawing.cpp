#include "drawing.h"

#include <algorithm>

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

auto key_of(const SphereShading& s) {
    return std::tuple(s.method, s.diffuse, s.specular, s.background, s.specular_filter, s.suns,
                      s.samples);
}

auto key_of(const SphereSources& s) {
    return std::tuple(s.background, s.blurred, s.irradiance, s.diffuse, s.specular,
                      s.prefilter_state, s.mips, s.ladder, s.clipped_tables, s.reference_diffuse,
                      s.reference_specular);
}

auto key_of(const Material& m) {
    return std::tuple(m.diffuse, m.specular, m.exponent);
}

// All but the material.
auto key_of(const SphereView& v) {
    return std::tuple(v.camera.eye, v.camera.target, v.camera.up, v.camera.vertical_field_of_view,
                      v.environment_rotation, v.background, v.width, v.height);
}

bool is_bound_alike(const DrawingRequest& a, const DrawingRequest& b) {
    return key_of(a.shading) == key_of(b.shading) && key_of(a.sources) == key_of(b.sources) &&
           a.version == b.version;
}

// Whether nothing but the sphere looks different.
bool has_same_surroundings(const DrawingRequest& a, const DrawingRequest& b) {
    return key_of(a.view) == key_of(b.view) && a.version == b.version &&
           a.shading.background == b.shading.background &&
           a.sources.background == b.sources.background;
}

} // namespace

std::size_t prefilter_passes(const FrameWork& work) {
    return std::size_t(std::count_if(work.begin(), work.end(), [](const host::PassReport& pass) {
        return pass.name != "sphere" && pass.name != "reference";
    }));
}

Outcome<SpherePipelines> SpherePipelines::create(host::Gpu& gpu) {
    const VkDevice device = gpu.device().handle;
    auto whole = make_colour_pass(device, Picture::FORMAT, Picture::LAYOUT);
    if (!whole) return whole.error();
    auto part = make_colour_pass(device, Picture::FORMAT, Picture::LAYOUT, true);
    if (!part) return part.error();
    return SpherePipelines(gpu, std::move(*whole), std::move(*part));
}

Outcome<const Sphere*> SpherePipelines::get(const SphereShading& shading) {
    const Key key = key_of(shading);
    if (const auto found = spheres_.find(key); found != spheres_.end()) return &found->second;
    auto sphere = Sphere::create(gpu_->device(), {.render_pass = whole_.get()}, shading);
    if (!sphere) return core_failure(sphere.error());
    return &spheres_.emplace(key, std::move(*sphere)).first->second;
}

Outcome<Done> Drawing::draw(host::Gpu& gpu, SpherePipelines& pipelines,
                            const DrawingRequest& request, FrameWork& work) {
    const SphereView& view = request.view;
    const bool bound = drawn_ && is_bound_alike(*drawn_, request);
    if (bound && key_of(drawn_->view) == key_of(view) &&
        key_of(drawn_->view.material) == key_of(view.material))
        return Done{};
    const VkExtent2D extent{view.width, view.height};
    if (!picture_ || picture_->extent().width != extent.width ||
        picture_->extent().height != extent.height) {
        drawn_.reset();
        picture_.reset();
        auto picture = Picture::create(gpu, pipelines.whole(), extent);
        if (!picture) return picture.error();
        picture_ = std::move(*picture);
    }
    if (!bound || !job_) {
        const auto sphere = pipelines.get(request.shading);
        if (!sphere) return sphere.error();
        auto job = (*sphere)->bind(request.sources);
        if (!job) return core_failure(job.error());
        job_ = std::move(*job);
    }
    const bool keeps = drawn_ && has_same_surroundings(*drawn_, request);
    const VkRect2D part = keeps ? sphere_bounds(view) : VkRect2D{{0, 0}, extent};
    const auto milliseconds = gpu.submit_timed([&](VkCommandBuffer commands) {
        picture_->record(commands, keeps ? pipelines.part() : pipelines.whole(),
                         [&](VkCommandBuffer inside) { job_->record(inside, view, part); });
    });
    if (!milliseconds) return milliseconds.error();
    drawn_ = request;
    const std::uint64_t pixels = std::uint64_t(part.extent.width) * part.extent.height;
    work.push_back({.name = "sphere",
                    .invocations = pixels,
                    .bytes_written = 16 * pixels,
                    .gpu_ms = *milliseconds});
    return Done{};
}

} // namespace lobelia::cli
