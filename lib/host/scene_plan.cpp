#include "host/scene_plan.h"

#include "host/averages.h"
#include "host/camera.h"
#include "host/checks.h"
#include "host/maps.h"
#include "host/mips.h"

namespace lobelia::host {

Outcome<Done> check_render(const Gpu& gpu, const RenderSettings& settings) {
    if (const auto refused = check_view(settings.view, gpu.limits())) return *refused;
    if (const auto refused = check_material(settings.view.material, true)) return *refused;
    if (settings.background_exponent != RenderSettings{}.background_exponent)
        if (const auto refused = check_exponent(settings.background_exponent))
            return Failure{"of the background's blur " + refused->message};
    if (settings.samples < 1 || settings.samples > SphereShading::MOST_SAMPLES)
        return Failure{"there are " + std::to_string(settings.samples) + " samples, give 1 to " +
                       std::to_string(SphereShading::MOST_SAMPLES)};
    return Done{};
}

Outcome<ScenePlan> plan_scene(const Gpu& gpu, std::uint32_t face, bool constant,
                              const RenderSettings& settings, float levels_up_to) {
    const Material& material = settings.view.material;
    const SceneMaterial shown{material.diffuse, material.specular, material.exponent,
                              material.exponent};
    const bool lit = sees_sphere(settings.view);
    const auto plan = ScenePlan::make({.materials = {&shown, lit ? std::size_t(1) : 0},
                                       .background = settings.view.background,
                                       .background_exponent = settings.background_exponent,
                                       .method = settings.method,
                                       .quality = settings.quality,
                                       .samples = settings.samples,
                                       .constant = constant,
                                       .source_size = prefilter_face(face),
                                       .background_size = face,
                                       .mips_format = mips_format(gpu),
                                       .width = settings.view.width,
                                       .height = settings.view.height,
                                       .levels_up_to = levels_up_to});
    if (!plan) return core_failure(plan.error());
    return *plan;
}

const ScenePass* find_pass(const ScenePlan& plan, std::string_view name) {
    for (const ScenePass& pass : plan.passes())
        if (name == pass.name) return &pass;
    return nullptr;
}

const SceneResource* find_resource(const ScenePlan& plan, std::string_view name) {
    for (const SceneResource& resource : plan.resources())
        if (name == resource.name) return &resource;
    return nullptr;
}

PassReport report_of(const ScenePass& pass) {
    return {.name = pass.name,
            .invocations = pass.invocations,
            .bytes_read = pass.bytes_read,
            .bytes_written = pass.bytes_written};
}

std::vector<ImageReport> image_reports(const ScenePlan& plan) {
    std::vector<ImageReport> reports;
    for (const SceneResource& resource : plan.resources())
        if (resource.format != VK_FORMAT_UNDEFINED)
            reports.push_back({resource.name, resource.width, resource.height, resource.layers,
                               resource.levels, format_name(resource.format), resource.bytes,
                               resource.kept ? "kept" : "scratch"});
    return reports;
}

std::vector<PassReport> reference_passes(const ScenePlan& plan, const SphereView& view,
                                         std::uint64_t source_bytes) {
    const SphereShading& shading = plan.shading();
    std::vector<PassReport> passes;
    if (shading.method != SphereMethod::reference) return passes;
    const std::size_t pixels = sphere_pixels(view).size();
    if (shading.diffuse) passes.push_back(exact_pass("diffuse reference", source_bytes, pixels));
    if (shading.specular) passes.push_back(exact_pass("specular reference", source_bytes, pixels));
    return passes;
}

} // namespace lobelia::host
