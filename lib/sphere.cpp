#include <lobelia/sphere.h>

#include <cmath>

#include <lobelia/lobe.h>

#include "camera_rays.h"
#include "vk/full_screen_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

struct vec4 {
    float x, y, z, w;
};
#include "lobelia/sphere_params.glsl"
static_assert(sizeof(SphereParams) == 128);

constexpr std::uint32_t VERTEX_SPIRV[] = {
#include "sphere.vert.inc"
};
constexpr std::uint32_t SPLIT_SUM_SPIRV[] = {
#include "sphere.frag.inc"
};
constexpr std::uint32_t PREFILTERED_SPIRV[] = {
#include "sphere_prefiltered.frag.inc"
};
constexpr std::uint32_t REFERENCE_SPIRV[] = {
#include "sphere_reference.frag.inc"
};

constexpr VkDescriptorType SPLIT_SUM_BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // background
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // diffuse map
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // specular map
};
constexpr VkDescriptorType PREFILTERED_BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // background
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // diffuse map
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // specular map
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // the maps' scale and suns
};
constexpr VkDescriptorType REFERENCE_BINDINGS[] = {
    VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, // background
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // diffuse averages
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         // specular averages
};

/// The fragment shader that draws with a shading, and what it reads.
struct Program {
    std::span<const std::uint32_t> spirv;
    std::span<const VkDescriptorType> bindings;
};

Program program_for(const SphereShading& shading) {
    if (shading.method == SphereMethod::reference) return {REFERENCE_SPIRV, REFERENCE_BINDINGS};
    if (shading.prefiltered) return {PREFILTERED_SPIRV, PREFILTERED_BINDINGS};
    return {SPLIT_SUM_SPIRV, SPLIT_SUM_BINDINGS};
}

vec4 to_vec4(Vector a, float w) {
    return {float(a.x), float(a.y), float(a.z), w};
}

SphereParams make_params(const SphereView& view) {
    const CameraRays rays = camera_rays(view);
    const auto& [kd, ks, exponent] = view.material;
    return {.direction = to_vec4(rays.centre, kd[0]),
            .direction_per_x = to_vec4(rays.per_x, kd[1]),
            .direction_per_y = to_vec4(rays.per_y, kd[2]),
            .moment = to_vec4(cross(rays.eye, rays.centre), ks[0]),
            .moment_per_x = to_vec4(cross(rays.eye, rays.per_x), ks[1]),
            .moment_per_y = to_vec4(cross(rays.eye, rays.per_y), ks[2]),
            .centre = to_vec4(-1.0 * rays.eye,
                              float(std::sqrt(std::max(dot(rays.eye, rays.eye) - 1.0, 0.0)))),
            .exponent = exponent,
            .width = view.width,
            .height = view.height,
            .background = view.background};
}

} // namespace

struct Sphere::State {
    vk::Context context;
    SphereShading shading;
    std::span<const VkDescriptorType> bindings;
    vk::Sampler sampler;
    vk::FullScreenPass pass;
};

struct SphereJob::State {
    std::shared_ptr<const Sphere::State> shared;
    vk::DescriptorSets sets;
};

Sphere::Sphere(std::shared_ptr<State> state) noexcept : state_(std::move(state)) {}
Sphere::Sphere(Sphere&&) noexcept = default;
Sphere& Sphere::operator=(Sphere&&) noexcept = default;
Sphere::~Sphere() = default;

Result<Sphere> Sphere::create(const Device& device, const SphereTarget& target,
                              const SphereShading& shading) {
    return vk::guarded([&]() -> Result<Sphere> {
        if (!target.render_pass && target.format == VK_FORMAT_UNDEFINED)
            return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                         "SphereTarget needs a render pass or a format"};
        auto context = vk::load(device);
        if (!context) return context.error();
        auto state = std::make_shared<State>();
        state->context = *context;
        state->shading = shading;
        const Program program = program_for(shading);
        state->bindings = program.bindings;
        auto sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);
        if (!sampler) return sampler.error();
        state->sampler = std::move(*sampler);

        const VkBool32 constants[] = {shading.diffuse, shading.specular, shading.background,
                                      shading.specular_filter == MapFilter::spline};
        const vk::FullScreenPassDescription description{.vertex_spirv = VERTEX_SPIRV,
                                                        .fragment_spirv = program.spirv,
                                                        .bindings = state->bindings,
                                                        .push_constant_size = sizeof(SphereParams),
                                                        .constants = constants,
                                                        .render_pass = target.render_pass,
                                                        .subpass = target.subpass,
                                                        .format = target.format};
        auto pass = vk::make_full_screen_pass(state->context, description);
        if (!pass) return pass.error();
        state->pass = std::move(*pass);
        return Sphere(std::move(state));
    });
}

Result<SphereJob> Sphere::bind(const SphereSources& sources) const {
    return vk::guarded([&]() -> Result<SphereJob> {
        const SphereShading& shading = state_->shading;
        const bool reference = shading.method == SphereMethod::reference;
        const auto missing = [&](bool used, bool map, bool buffer) {
            return used && !(reference ? buffer : map);
        };
        if (!sources.background ||
            missing(shading.diffuse, sources.diffuse, sources.reference_diffuse) ||
            missing(shading.specular, sources.specular, sources.reference_specular) ||
            (!reference && shading.prefiltered && !sources.prefilter_state))
            return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                         "SphereSources lacks what the shading reads"};
        if (reference && !sources.reference_diffuse && !sources.reference_specular)
            return Error{VK_ERROR_VALIDATION_FAILED_EXT,
                         "a reference of neither lobe has nothing to show"};

        // Every binding is written: some drivers read descriptors that the shader does not.
        const auto map = [&](VkImageView view) {
            return vk::sampled_image(view ? view : sources.background, state_->sampler.get());
        };
        const auto buffer = [&](VkBuffer wanted, VkBuffer other) {
            return vk::buffer_range(wanted ? wanted : other);
        };
        const VkBuffer diffuse = sources.reference_diffuse;
        const VkBuffer specular = sources.reference_specular;
        const vk::Resource resources[] = {
            map(sources.background),
            reference ? buffer(diffuse, specular) : map(sources.diffuse),
            reference ? buffer(specular, diffuse) : map(sources.specular),
            vk::buffer_range(sources.prefilter_state),
        };
        auto sets = vk::make_descriptor_sets(
            state_->context, state_->pass.interface.set_layout.get(), state_->bindings, 1);
        if (!sets) return sets.error();
        vk::write_descriptor_set(state_->context, sets->sets[0], state_->bindings, resources);
        return SphereJob(
            std::unique_ptr<SphereJob::State>(new SphereJob::State{state_, std::move(*sets)}));
    });
}

SphereJob::SphereJob(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
SphereJob::SphereJob(SphereJob&&) noexcept = default;
SphereJob& SphereJob::operator=(SphereJob&&) noexcept = default;
SphereJob::~SphereJob() = default;

void SphereJob::record(VkCommandBuffer commands, const SphereView& view) const noexcept {
    vk::draw_full_screen(state_->shared->context, commands, state_->shared->pass,
                         state_->sets.sets[0], make_params(view), view.width, view.height);
}

} // namespace lobelia
