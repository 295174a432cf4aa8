#include <lobelia/sphere.h>

#include "sphere_methods.h"
#include "sphere_params.h"
#include "vk/full_screen_pass.h"
#include "vk/guard.h"

namespace lobelia {

namespace {

constexpr std::uint32_t VERTEX_SPIRV[] = {
#include "sphere.vert.inc"
};

std::vector<VkDescriptorType> types_of(std::span<const SphereBinding> bindings) {
    std::vector<VkDescriptorType> types;
    for (const SphereBinding& binding : bindings) types.push_back(binding.type);
    return types;
}

bool is_there(const SphereBinding& binding, const SphereSources& sources) {
    return binding.view ? sources.*binding.view != VK_NULL_HANDLE
                        : sources.*binding.buffer != VK_NULL_HANDLE;
}

// The binding itself, or the first of its type that has something to refer to.
const SphereBinding* stand_in(const SphereBinding& binding, std::span<const SphereBinding> bindings,
                              const SphereSources& sources) {
    if (is_there(binding, sources)) return &binding;
    for (const SphereBinding& other : bindings)
        if (other.type == binding.type && is_there(other, sources)) return &other;
    return nullptr;
}

vk::Resource resource(const SphereBinding& binding, const SphereSources& sources,
                      VkSampler sampler) {
    return binding.view ? vk::sampled_image(sources.*binding.view, sampler)
                        : vk::buffer_range(sources.*binding.buffer);
}

} // namespace

struct Sphere::State {
    vk::Context context;
    SphereShading shading;
    std::span<const SphereBinding> bindings;
    std::vector<VkDescriptorType> types; // of the bindings
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
        const SphereMethodEntry* const method = find_method(shading.method);
        if (!method)
            return Error{VK_ERROR_VALIDATION_FAILED_EXT, "SphereShading has no such method"};
        if (shading.samples < 1 || shading.samples > SphereShading::MOST_SAMPLES)
            return Error{VK_ERROR_VALIDATION_FAILED_EXT, "SphereShading takes 1 to 1024 samples"};
        auto context = vk::load(device);
        if (!context) return context.error();
        auto state = std::make_shared<State>();
        state->context = *context;
        state->shading = shading;
        state->bindings = method->bindings;
        state->types = types_of(method->bindings);
        auto sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);
        if (!sampler) return sampler.error();
        state->sampler = std::move(*sampler);

        const std::uint32_t constants[] = {
            shading.diffuse,    shading.specular,
            shading.background, shading.specular_filter == MapFilter::spline,
            method->variant,    shading.samples,
            shading.suns,
        };
        const vk::FullScreenPassDescription description{.vertex_spirv = VERTEX_SPIRV,
                                                        .fragment_spirv = method->spirv,
                                                        .bindings = state->types,
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
        const Error lacking{VK_ERROR_VALIDATION_FAILED_EXT,
                            "SphereSources lacks what the shading reads"};
        if (!sources.background) return lacking;
        std::vector<vk::Resource> resources;
        for (const SphereBinding& binding : state_->bindings) {
            const bool needed =
                (binding.diffuse && shading.diffuse) || (binding.specular && shading.specular);
            if (needed && !is_there(binding, sources)) return lacking;
            const SphereBinding* const found = stand_in(binding, state_->bindings, sources);
            if (!found) return lacking;
            resources.push_back(resource(*found, sources, state_->sampler.get()));
        }
        auto sets = vk::make_descriptor_sets(
            state_->context, state_->pass.interface.set_layout.get(), state_->types, 1);
        if (!sets) return sets.error();
        vk::write_descriptor_set(state_->context, sets->sets[0], state_->types, resources);
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
