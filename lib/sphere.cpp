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

Result<Sphere> Sphere::create(const Device& device, const SphereTarget& target,
                              const SphereShading& shading) {
    return vk::guarded<Sphere>([&] {
        if (!target.render_pass && target.format == VK_FORMAT_UNDEFINED)
            vk::refuse("SphereTarget needs a render pass or a format");
        const SphereMethodEntry* const method = find_method(shading.method);
        if (!method) vk::refuse("SphereShading has no such method");
        if (shading.samples < 1 || shading.samples > SphereShading::MOST_SAMPLES)
            vk::refuse("SphereShading takes 1 to 1024 samples");
        auto state = std::make_shared<State>();
        state->context = vk::load(device);
        state->shading = shading;
        state->bindings = method->bindings;
        state->types = types_of(method->bindings);
        state->sampler = vk::make_sampler(state->context, VK_FILTER_LINEAR);

        const std::uint32_t constants[] = {
            shading.diffuse,    shading.specular,
            shading.background, shading.specular_filter == MapFilter::spline,
            method->variant,    shading.samples,
            shading.suns,
        };
        const vk::FullScreenPassDescription description{.name = "lobelia sphere",
                                                        .vertex_spirv = VERTEX_SPIRV,
                                                        .fragment_spirv = method->spirv,
                                                        .bindings = state->types,
                                                        .push_constant_size = sizeof(SphereParams),
                                                        .constants = constants,
                                                        .render_pass = target.render_pass,
                                                        .subpass = target.subpass,
                                                        .format = target.format};
        state->pass = vk::make_full_screen_pass(state->context, description);
        return Sphere(std::move(state));
    });
}

Result<SphereJob> Sphere::bind(const SphereSources& sources) const {
    return vk::guarded<SphereJob>([&] {
        const SphereShading& shading = state_->shading;
        const char* const lacking = "SphereSources lacks what the shading reads";
        if (!sources.background) vk::refuse(lacking);
        std::vector<vk::Resource> resources;
        for (const SphereBinding& binding : state_->bindings) {
            const bool needed =
                (binding.diffuse && shading.diffuse) || (binding.specular && shading.specular);
            if (needed && !is_there(binding, sources)) vk::refuse(lacking);
            const SphereBinding* const found = stand_in(binding, state_->bindings, sources);
            if (!found) vk::refuse(lacking);
            resources.push_back(resource(*found, sources, state_->sampler.get()));
        }
        auto sets = vk::make_descriptor_set(state_->context, state_->pass.interface, state_->types,
                                            resources);
        return SphereJob(
            std::make_shared<SphereJob::State>(SphereJob::State{state_, std::move(sets)}));
    });
}

void SphereJob::record(VkCommandBuffer commands, const SphereView& view) const noexcept {
    record(commands, view, {{0, 0}, {view.width, view.height}});
}

void SphereJob::record(VkCommandBuffer commands, const SphereView& view,
                       const VkRect2D& part) const noexcept {
    const vk::Label label(state_->shared->context, commands, "lobelia sphere");
    vk::draw_full_screen(state_->shared->context, commands, state_->shared->pass,
                         state_->sets.sets[0], make_params(view), view.width, view.height, part);
}

} // namespace lobelia
