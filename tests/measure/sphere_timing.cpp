#include "sphere_timing.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "host/averages.h"
#include "host/mips.h"
#include "sphere_params.h"
#include "support/gpu_sources.h"

namespace lobelia::test {

namespace {

constexpr std::uint32_t TIMED_SIZE = 512; // pixels a side
constexpr int ROUNDS = 15;

constexpr std::uint32_t VERTEX_SPIRV[] = {
#include "sphere.vert.inc"
};
constexpr std::uint32_t MIRROR_SPIRV[] = {
#include "mirror.frag.inc"
};
constexpr std::uint32_t FOLDED_SPIRV[] = {
#include "kurt2019_folded.frag.inc"
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

SphereTimer::SphereTimer(host::Gpu& gpu, const host::GpuEnvironment& environment,
                         const Material& material, Quality quality)
    : gpu_(gpu), environment_(environment), view_{.material = material,
                                                  .width = TIMED_SIZE,
                                                  .height = TIMED_SIZE},
      quality_(quality), target_(value_of(host::ColourTarget::create(gpu, TIMED_SIZE, TIMED_SIZE))),
      context_(vk::load(gpu.device())), sampler_(vk::make_sampler(context_, VK_FILTER_LINEAR)),
      colours_(value_of(gpu.create_buffer(6 * 4 * sizeof(float), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                          host::Memory::host))) {
    std::memset(colours_.data(), 0, colours_.size());
    images_.push_back(
        value_of(host::make_mips(gpu, environment, 1, MipWeights::solid_angle)).image);
    add_shader("mirror", MIRROR_SPIRV, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
               vk::sampled_image(images_.back().view(), sampler_.get()));
    add_shader("kurt2019, colours known", FOLDED_SPIRV, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
               vk::buffer_range(colours_.handle()));
}

void SphereTimer::add_shader(const std::string& name, std::span<const std::uint32_t> spirv,
                             VkDescriptorType type, const vk::Resource& resource) {
    const VkDescriptorType bindings[] = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, type};
    const std::uint32_t constants[] = {view_.material.diffuse[0] > 0.0f, 1, 1};
    auto pass = std::make_shared<vk::FullScreenPass>(
        vk::make_full_screen_pass(context_, {.name = "lobelia timing",
                                             .vertex_spirv = VERTEX_SPIRV,
                                             .fragment_spirv = spirv,
                                             .bindings = bindings,
                                             .push_constant_size = sizeof(SphereParams),
                                             .constants = constants,
                                             .render_pass = target_.render_pass(),
                                             .subpass = 0,
                                             .format = VK_FORMAT_UNDEFINED}));
    auto sets = std::make_shared<vk::DescriptorSets>(
        vk::make_descriptor_sets(context_, pass->interface, bindings, 1));
    const vk::Resource resources[] = {vk::sampled_image(environment_.cube.view(), sampler_.get()),
                                      resource};
    vk::write_descriptor_set(context_, sets->sets[0], bindings, resources);
    drawings_.push_back({name, [this, pass, sets](VkCommandBuffer commands) {
                             vk::draw_full_screen(context_, commands, *pass, sets->sets[0],
                                                  make_params(view_), TIMED_SIZE, TIMED_SIZE,
                                                  {{0, 0}, {TIMED_SIZE, TIMED_SIZE}});
                         }});
}

void SphereTimer::add(const std::string& name, SphereMethod method, std::uint32_t samples) {
    add(name, method, samples, true);
}

void SphereTimer::add_without_suns(const std::string& name, SphereMethod method) {
    add(name, method, 1, false);
}

void SphereTimer::add(const std::string& name, SphereMethod method, std::uint32_t samples,
                      bool suns) {
    auto inputs = std::make_shared<host::SphereInputs>(value_of(host::make_sphere_inputs(
        gpu_, environment_,
        {.view = view_, .method = method, .quality = quality_, .samples = samples}, {})));
    suns_ = std::max(suns_, inputs->report.suns.value_or(0));
    inputs->shading.suns = inputs->shading.suns && suns;
    const Sphere sphere = value_of(
        Sphere::create(gpu_.device(), {.render_pass = target_.render_pass()}, inputs->shading));
    auto job = std::make_shared<SphereJob>(value_of(sphere.bind(inputs->sources)));
    drawings_.push_back(
        {name, [this, inputs, job](VkCommandBuffer commands) { job->record(commands, view_); }});
}

std::vector<SphereTiming> SphereTimer::run() {
    std::vector<std::vector<double>> times(drawings_.size());
    for (int round = -1; round < ROUNDS; ++round) // the first one compiles
        for (std::size_t i = 0; i < drawings_.size(); ++i) {
            host::PassReport report;
            value_of(host::run_pass(gpu_, report, [&](VkCommandBuffer commands) {
                target_.record(commands, drawings_[i].record);
            }));
            if (round >= 0) times[i].push_back(*report.cpu_ms);
        }
    std::vector<SphereTiming> timings;
    for (std::size_t i = 0; i < drawings_.size(); ++i)
        timings.push_back(
            {drawings_[i].name, median(times[i]), median(times[i]) / median(times[0])});
    return timings;
}

} // namespace lobelia::test
